// SPDX-License-Identifier: MIT
// How close a pair of spheres is to touching, for the report of a difference.
#pragma once

#include <string>

#include "common/shared/exact.h"

namespace spherepair {

struct Margin {
  bool collide;      // as the exact integer stages decide
  bool finite;       // all inputs are finite
  long double ulps;  // (S - Q) / Q in units of 2^-24, evaluated in long double
};
Margin margin_of(vec4 a, vec4 b);
std::string describe(const Margin& margin);

}  // namespace spherepair
