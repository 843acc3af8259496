// SPDX-License-Identifier: MIT
// Rounds a file's numbers to float32, and tells what that changes and how far it can move a sphere's surface.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "bench/spheres/columns.h"
#include "common/shared/layout.h"

namespace spherepair {

// The numbers of a file's spheres, filled by its reader: different spheres may be set by different threads.
struct SphereRows {
  std::vector<vec4> positions, velocities;   // velocities: empty if the file has none
  std::vector<std::array<double, 4>> exact;  // x y z radius in float64; empty if all numbers are float32 or shorter
  std::vector<std::string_view> species;     // in the file's bytes; empty unless asked for

  void resize(uint64_t n, double radius, bool with_velocities, bool with_exact);
  void add(double radius);  // appends one more, with a velocity and exact numbers
  void set(uint64_t sphere, Quantity quantity, const Decimal& number);
};

struct Rounding {
  std::array<double, 3> shift = {};  // subtracted from every centre before rounding; no number loses a bit by it
  std::vector<float> reach = {};     // of each sphere: an upper bound of how far rounding moved its surface, metres;
                                     // empty if it moved none
  float largest = 0;                 // of them
};

// Rounds the exact rows into the positions. may_shift: first subtracts the middle of the spheres, rounded to a power of
// two of their extent, along every axis on which all differences are exact in float64.
Rounding round_rows(SphereRows& rows, bool may_shift);

// Adds a distance to the reach of every sphere, if rounding moved any.
void widen(Rounding& rounding, double way);

// A positive number in two digits, rounded up, so that the printed text is an upper bound.
std::string at_most(double value);

// The spheres with all radii larger (grown) or smaller (shrunk) by their reach. Two grown spheres that do not overlap
// stand for no pair, two shrunk ones that overlap for a pair, wherever within the reach the surfaces are.
std::vector<vec4> grown(std::span<const vec4> spheres, std::span<const float> reach);
std::vector<vec4> shrunk(std::span<const vec4> spheres, std::span<const float> reach);

}  // namespace spherepair
