// SPDX-License-Identifier: MIT
// From one point of a pair to the other, x_j - x_i + S H, and whether that is within reach: in real arithmetic on the
// numbers as given. A float64 filter with the bound of its roundings decides first, exact sums what it leaves.
#pragma once

#include "common/lists/list_problem.h"

namespace spherepair {

struct ListedPair {
  uint32_t first, second;
  Shift shift;
  auto operator<=>(const ListedPair&) const = default;
};

bool is_within_reach(const ListProblem& problem, const ListBox& box, const ListedPair& pair);

// c^2 - |x_j - x_i + S H|^2, at most one unit in the last place from the real number.
double squared_gap(const ListProblem& problem, const ListBox& box, const ListedPair& pair);

// Each component at most one unit in the last place from the real number.
Point3 displacement(const ListProblem& problem, const ListBox& box, const ListedPair& pair);

// Of a displacement; its relative error is below 2^-50.
double length(const Point3& vector);

}  // namespace spherepair
