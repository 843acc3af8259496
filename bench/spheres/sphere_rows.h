// SPDX-License-Identifier: MIT
// The numbers of a file's spheres, in float32 and in float64.
#pragma once

#include <string>
#include <vector>

#include "bench/spheres/columns.h"
#include "common/lists/list_problem.h"
#include "common/shared/layout.h"

namespace spherepair {

// Filled by a file's reader: different spheres may be set by different threads.
struct SphereRows {
  std::vector<vec4> positions, velocities;  // velocities: empty if the file has none
  PointSet exact;                           // in float64; empty if all numbers are float32 or shorter
  std::vector<std::string_view> species;    // in the file's bytes; empty unless asked for

  void resize(uint64_t n, double radius, bool with_velocities, bool with_exact);
  void add(double radius);  // appends one more, with a velocity and exact numbers
  void set(uint64_t sphere, Quantity quantity, const Decimal& number);
};

// An upper bound of how far rounding to float32 moved a sphere's surface, in the file's unit of length.
float largest_rounding(const SphereRows& rows);

// A positive number in two digits, rounded up, so that the printed text is an upper bound.
std::string at_most(double value);

}  // namespace spherepair
