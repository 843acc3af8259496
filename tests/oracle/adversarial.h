// SPDX-License-Identifier: MIT
// Pairs of spheres chosen to be hard to decide: rows 1 to 8 of the stress catalogue. Each pair is a function of the
// family and its index alone.
#pragma once

#include <cstdint>
#include <vector>

#include "common/shared/hash.h"

namespace spherepair {

// A stream of random numbers from one 64-bit seed.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(splitmix64(seed)) {}
  uint64_t next() { return splitmix64(state_ += 0x9E3779B97F4A7C15u); }
  uint64_t below(uint64_t bound) { return uint64_t((unsigned __int128)(next()) * bound >> 64); }
  int between(int low, int high) { return low + int(below(uint64_t(high - low) + 1)); }
  double uniform(double low, double high) { return low + (high - low) * (double(next() >> 11) * 0x1p-53); }
  float sign() { return next() >> 63 ? -1.0f : 1.0f; }

 private:
  uint64_t state_;
};

enum class Family {
  random_bits,    // row 1: random bit patterns, all exponents
  near_tangent,   // row 2: tangent to within 8 ulp, boxes of 8, 1e4 and 1e6
  quadruple,      // row 3: Pythagorean quadruples times powers of two: all exactly tangent
  quadruple_off,  // row 4: the same with one input 1 ulp off
  denormal,       // row 5: every input denormal
  extreme,        // row 6: squares around the largest float, or radii of 2^-115 to 2^-45
  axis_offset,    // row 7: tangent along an axis but for an offset around 2^-140
  nonfinite,      // row 8: NaN and infinities in every subset of the inputs; repeats after NONFINITE_CASES
  beyond_double,  // differences of 48 bits, whose squares float64 rounds past the squared sum of radii
};
constexpr uint64_t NONFINITE_CASES = 2 * 390625;  // two pairs of spheres, five kinds of value in each of eight inputs

// x moved by so many representable numbers; x must stay finite.
float nudged(float x, int ulps);

// Pairs first .. first + count - 1 of the family: sphere 2k against sphere 2k + 1.
std::vector<vec4> adversarial_pairs(Family family, uint64_t first, uint64_t count);

}  // namespace spherepair
