// SPDX-License-Identifier: MIT
// Whether a sphere collides with the nearest image of another in a periodic box: |a - b + S(high - low)| < a.w + b.w in
// real arithmetic on the float32 corners, centres and radii. The box is longer than two reaches (periodic.h).
#ifndef SPHEREPAIR_IMAGE_PAIR_H
#define SPHEREPAIR_IMAGE_PAIR_H

#include "common/shared/contact/periodic.h"
#include "common/shared/exact.h"

// Returns |a - b + shift (high - low)| in units of 2^(base - 150).
FN Wide magnitude_of_way(float a, float b, float low, float high, int shift, uint base, uint words) {
  uint add = float_bits(shift > 0 ? high : low);
  uint subtract = float_bits(shift > 0 ? low : high);
  Wide sum;
  int64_t carry = int64_t(0);
  for (uint k = 0u; k < words; ++k) {
    carry += signed_word(float_bits(a), base, k) - signed_word(float_bits(b), base, k);
    if (shift != 0) carry += signed_word(add, base, k) - signed_word(subtract, base, k);
    sum.word[k] = uint(carry & int64_t(0xFFFFFFFFul));
    carry = carry >> 32;
  }
  return magnitude_of(sum, carry, words);
}

FN uint lowest_of(vec4 v, uint lowest) {
  return lowest_scale(float_bits(v.x), lowest_scale(float_bits(v.y), lowest_scale(float_bits(v.z), lowest)));
}
FN uint highest_of(vec4 v, uint highest) {
  return highest_scale(float_bits(v.x), highest_scale(float_bits(v.y), highest_scale(float_bits(v.z), highest)));
}

// Decides pairs across a face in integers, without a filter: they are few. A sum of four floats takes one bit more than
// in decide_exact.
FN bool images_collide(vec4 a, vec4 b, ContactParams c, float scale, float offset) {
  int x_shift = nearest_shift(a.x, b.x, c.box_low.x, c.box_high.x);
  int y_shift = nearest_shift(a.y, b.y, c.box_low.y, c.box_high.y);
  int z_shift = nearest_shift(a.z, b.z, c.box_low.z, c.box_high.z);
  if (x_shift == 0 && y_shift == 0 && z_shift == 0) return decide_pair(a, b, scale, offset).collide;
  uint base = lowest_of(a, lowest_of(b, lowest_of(c.box_low, lowest_of(c.box_high, 254u))));
  base = lowest_scale(float_bits(a.w), lowest_scale(float_bits(b.w), base));
  uint top = highest_of(a, highest_of(b, highest_of(c.box_low, highest_of(c.box_high, base))));
  top = highest_scale(float_bits(a.w), highest_scale(float_bits(b.w), top));
  uint words = (top - base + 58u) >> 5;
  Wide x = magnitude_of_way(a.x, b.x, c.box_low.x, c.box_high.x, x_shift, base, words);
  Wide y = magnitude_of_way(a.y, b.y, c.box_low.y, c.box_high.y, y_shift, base, words);
  Wide z = magnitude_of_way(a.z, b.z, c.box_low.z, c.box_high.z, z_shift, base, words);
  Wide r = magnitude_of_sum(float_bits(a.w), float_bits(b.w), base, words);
  return squares_less(x, y, z, r, words);
}

#endif
