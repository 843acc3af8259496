// SPDX-License-Identifier: MIT
// Numbers of a pair, in float64 from the float32 spheres: contact, distance, and whether it is within a cutoff.
#pragma once

#include <array>
#include <span>

#include "common/scene/pair_set.h"
#include "common/shared/layout.h"

namespace spherepair {

// The contact of a pair: the overlap in metres; the unit vector from the centre of `first` to the centre of `second`
// (zero if they coincide); and the point in the middle of the overlap, on the line of centres. In float64 from the
// float32 spheres; `shift` is added to the points. The overlap is positive for every pair that collides, with a
// relative error below 2^-50.
struct Contact {
  double overlap;
  std::array<double, 3> normal, point;
};
Contact contact_of(const Pair& pair, std::span<const vec4> spheres, const std::array<double, 3>& shift = {});

// The distance of the centres, with a relative error below 2^-51.
double distance_of(const Pair& pair, std::span<const vec4> spheres);

// A radius with which spheres overlap for every pair of centres at most `cutoff` apart, and for few others.
float radius_above(double cutoff);
// Whether the distance is at most the cutoff, in real arithmetic. The cutoff must not be negative and must be within
// the range of float32.
bool is_within(const Pair& pair, std::span<const vec4> spheres, double cutoff);

}  // namespace spherepair
