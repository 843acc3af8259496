// SPDX-License-Identifier: MIT
// The gap of a contact. Its lengths are integers, in units of 2^-29 of the power of two below the reach (the sum of the
// radii). Their squares and the difference of two squares are exact.
#ifndef SPHEREPAIR_GAP_H
#define SPHEREPAIR_GAP_H

#include "common/shared/contact/fixed.h"
#include "common/shared/layout.h"
#include "common/shared/round.h"

// The vector from one centre, or from a wall, to the other centre.
struct Gap {
  int64_t x, y, z;
  uint64_t square;  // of the distance
  uint64_t reach;
  float scale;  // metres in 2^29 of these units, relative to the largest reach
};

const uint64_t FAR_APART = 0xFFFFFFFFFFFFFFFFul;

FN Gap gap_of(int64_t dx, int64_t dy, int64_t dz, float reach, ContactParams c) {
  int exponent = int(exponent_field(reach)) - 127;
  int bits = c.unit_exponent + exponent - 29;
  Gap g = {shifted(dx, bits),
           shifted(dy, bits),
           shifted(dz, bits),
           FAR_APART,
           uint64_t(significand(reach)) << 6,
           power_of_two(exponent - c.reach_exponent)};
  if (magnitude(g.x) < g.reach && magnitude(g.y) < g.reach && magnitude(g.z) < g.reach)
    g.square = uint64_t(g.x * g.x) + uint64_t(g.y * g.y) + uint64_t(g.z * g.z);
  return g;
}
FN bool in_contact(Gap g) { return g.square < g.reach * g.reach; }
FN bool deeper_than(Gap g, float radius, float reach) {
  EXACT float units = radius * power_of_two(156 - int(exponent_field(reach)));  // 29 - exponent
  uint64_t left = g.reach - uint64_t(uint(units));
  return g.square < left * left;
}

FN float unit_length(int64_t x) {
  EXACT float length = float_of(x) * power_of_two(-29);
  return length;
}

// For a gap that is not 0: 1 / distance, and the overlap, both in units of gap.scale.
struct Overlap {
  float inverse_distance, overlap;
};

// Takes the root of the square: a float guess, corrected by the remainder of the guess's own square, an integer.
FN Overlap overlap_of(Gap g) {
  EXACT float square = float_of(int64_t(g.square)) * power_of_two(-58);
  float guess = same_root(square);
  float inverse = same_reciprocal(guess);
  EXACT float digits = guess * power_of_two(29);
  uint64_t distance = uint64_t(uint(digits));
  EXACT float correction = float_of(int64_t(g.square - distance * distance)) * (inverse * power_of_two(-30));
  EXACT float overlap = (float_of(int64_t(g.reach - distance)) - correction) * power_of_two(-29);
  Overlap result = {inverse, larger(overlap, 0.0f)};
  return result;
}

#endif
