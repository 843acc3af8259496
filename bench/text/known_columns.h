// SPDX-License-Identifier: MIT
// The columns among the names of a file that are known.
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
PlainName plain_name(std::string_view text);  // `X [mm]`, `x(mm)`: x and mm

// A column whose name is known, and where it stands.
struct Candidate {
  const NamedColumn& column;
  const KnownName* known = nullptr;
  size_t at = 0;
  bool same_case = false;  // as the known name
  bool diameters = false;
};

// Of several for a quantity those whose names are better: pos than Z, z than Z.
std::vector<Candidate> candidates_of(std::span<const NamedColumn> names);

// What to do where names do not tell: --columns by order, with the first column of each quantity. Empty if x, y or z is
// not there.
std::string advice(const Columns& columns, std::span<const Candidate> candidates);

// Whether velocities are in the unit of lengths per time: m and m/s, m s^-1 or ms-1.
bool is_unit_per_time(std::string_view velocity, std::string_view length);

}  // namespace spherepair
