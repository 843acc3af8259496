// SPDX-License-Identifier: MIT
// The systems of a problem: where their points are, inside their boxes.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/lists/lattice.h"

namespace spherepair {

constexpr int64_t share_from = 1 << 14;  // points from which on several threads share the work

struct PointRange {
  Point3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
  void add(const Point3& point) {
    for (size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], point[k]), high[k] = std::max(high[k], point[k]);
  }
  bool empty() const { return low[0] > high[0]; }
};

// Of one system: where those that look are, and how far they reach.
struct System {
  PointRange inside, fractions;
  double reach = 0;    // of the two largest spheres
  double radius = 0;   // the largest that looks
  double rounded = 0;  // how far a coordinate of an image can be from its real number
};

// The system of each point.
std::vector<uint32_t> systems_of(const PointSet& set);

// The points inside their boxes: point = inside + cell H. Throws ListError for a point too far away; `name` is the
// set's.
std::vector<Point3> wrapped(const PointSet& set, const char* name, const std::vector<uint32_t>& systems,
                            const std::vector<Lattice>& lattices, std::vector<Shift>& cells);

// A point's share of the reach.
double radius_of(const ListProblem& problem, const PointSet& set, uint64_t i);

}  // namespace spherepair
