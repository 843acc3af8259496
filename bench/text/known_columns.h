// SPDX-License-Identifier: MIT
// Finds the known names among the columns of a file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/text/column_names.h"

namespace spherepair {

struct PlainName {
  std::string name, unit;
};
PlainName plain_name(std::string_view text);  // x and mm from `X [mm]` or `x(mm)`

// A column with a known name, and its place.
struct Candidate {
  const NamedColumn& column;
  const KnownName* known = nullptr;
  size_t at = 0;
  bool same_case = false;  // the same case as the known name
  bool diameters = false;
};

// The known columns. If several fit a quantity, those with better names: pos rather than Z, z rather than Z.
std::vector<Candidate> candidates_of(std::span<const NamedColumn> names);

// The advice if names are ambiguous: --columns by order, with the first column of each quantity. Empty if x, y or z is
// missing.
std::string advice(const Columns& columns, std::span<const Candidate> candidates);

// Whether velocities are in the unit of lengths per time: m and m/s, m s^-1 or ms-1.
bool is_unit_per_time(std::string_view velocity, std::string_view length);

}  // namespace spherepair
