// SPDX-License-Identifier: MIT
// The exact stages of the collision predicate, for the few pairs that the filter leaves undecided: float64 with the
// same two-sided test, then integers. Floats are taken apart by their bits, so flushed denormals cannot change a
// result.
#ifndef SPHEREPAIR_EXACT_H
#define SPHEREPAIR_EXACT_H

#include "common/shared/predicate.h"

const uint STAGE_FLOAT = 0u;      // the float32 filter decided
const uint STAGE_DOUBLE = 1u;     // float64
const uint STAGE_INTEGER = 2u;    // two-word integers: exponents span at most 38 bits
const uint STAGE_WIDE = 3u;       // up to nine words
const uint STAGE_NONFINITE = 4u;  // a NaN or an infinity: never a collision
#define STAGES 5

struct Verdict {
  bool collide;
  uint stage;
};
FN uint verdict_code(Verdict v) { return v.stage * 2u + (v.collide ? 1u : 0u); }

// Returns the exponent: |value| = mantissa * 2^(scale_of - 150).
FN uint scale_of(uint bits) {
  uint field = (bits >> 23) & 255u;
  return field == 0u ? 1u : field;
}
FN uint mantissa_of(uint bits) { return (bits & 0x7FFFFFu) | (((bits >> 23) & 255u) == 0u ? 0u : 0x800000u); }
FN bool finite_float(float x) { return ((float_bits(x) >> 23) & 255u) != 255u; }
FN bool finite_sphere(vec4 a) {
  return finite_float(a.x) && finite_float(a.y) && finite_float(a.z) && finite_float(a.w);
}

// Converts to float64, also if the hardware would flush a float32 denormal. x must be finite.
FN double exact_double(float x) {
  uint bits = float_bits(x);
  uint sign = bits & 0x80000000u;
  if (((bits >> 23) & 255u) != 0u) {
    uint magnitude = bits & 0x7FFFFFFFu;
    return bits_double(sign | ((magnitude >> 3) + (896u << 20)), magnitude << 29);
  }
  EXACT double denormal = double(bits & 0x7FFFFFu) * bits_double(0x36A00000u | sign, 0u);  // times 2^-149
  return denormal;
}

// Applies the filter again in float64. Differences of float32 are exact up to an exponent gap of 28 bits, and
// 1 + 24 * 2^-53 covers their rounding beyond it. Nothing under- or overflows.
FN uint decide_double(vec4 a, vec4 b) {
  EXACT double dx = exact_double(a.x) - exact_double(b.x);
  EXACT double dy = exact_double(a.y) - exact_double(b.y);
  EXACT double dz = exact_double(a.z) - exact_double(b.z);
  EXACT double r = exact_double(a.w) + exact_double(b.w);
  EXACT double s = (dx * dx + dy * dy) + dz * dz;
  EXACT double q = r * r;
  EXACT double apart_above = q * bits_double(0x3FF00000u, 12u);
  EXACT double collide_above = s * bits_double(0x3FF00000u, 12u);
  if (s > apart_above) return APART;
  if (q > collide_above) return COLLIDE;
  return UNDECIDED;
}

struct Wide {
  uint word[9];
};

// Returns word k of the float's magnitude as an integer in units of 2^(base - 150).
FN uint word_of(uint bits, uint base, uint k) {
  uint mantissa = mantissa_of(bits);
  if (mantissa == 0u) return 0u;
  uint shift = scale_of(bits) - base;
  uint64_t shifted = uint64_t(mantissa) << (shift & 31u);
  uint first = shift >> 5;
  if (k == first) return uint(shifted & 0xFFFFFFFFul);
  if (k == first + 1u) return uint(shifted >> 32);
  return 0u;
}

FN int64_t signed_word(uint bits, uint base, uint k) {
  int64_t word = int64_t(word_of(bits, base, k));
  return (bits & 0x80000000u) != 0u ? -word : word;
}

// Returns the magnitude of an integer, given its words and what they carry: -1 if it is negative.
FN Wide magnitude_of(Wide sum, int64_t carry, uint words) {
  if (carry < int64_t(0)) {
    uint64_t one = uint64_t(1u);
    for (uint k = 0u; k < words; ++k) {
      one += uint64_t(~sum.word[k]);
      sum.word[k] = uint(one & 0xFFFFFFFFul);
      one = one >> 32;
    }
  }
  return sum;
}

// Returns |x + y|, given the bits of both floats.
FN Wide magnitude_of_sum(uint x, uint y, uint base, uint words) {
  Wide sum;
  int64_t carry = int64_t(0);
  for (uint k = 0u; k < words; ++k) {
    carry += signed_word(x, base, k) + signed_word(y, base, k);
    sum.word[k] = uint(carry & int64_t(0xFFFFFFFFul));
    carry = carry >> 32;
  }
  return magnitude_of(sum, carry, words);
}

// Whether x*x + y*y + z*z < r*r. It adds the columns of the four squares with their signs, low to high; the carry out
// of the top is the sign of the difference.
FN bool squares_less(Wide x, Wide y, Wide z, Wide r, uint words) {
  int64_t carry = int64_t(0);
  int64_t high = int64_t(0);
  for (uint column = 0u; column < 2u * words; ++column) {
    int64_t low = carry + high;
    high = int64_t(0);
    uint first = column < words ? 0u : column - words + 1u;
    uint last = column < words ? column : words - 1u;
    for (uint k = first; k <= last; ++k) {
      uint64_t xx = uint64_t(x.word[k]) * uint64_t(x.word[column - k]);
      uint64_t yy = uint64_t(y.word[k]) * uint64_t(y.word[column - k]);
      uint64_t zz = uint64_t(z.word[k]) * uint64_t(z.word[column - k]);
      uint64_t rr = uint64_t(r.word[k]) * uint64_t(r.word[column - k]);
      low += int64_t(xx & 0xFFFFFFFFul) + int64_t(yy & 0xFFFFFFFFul) + int64_t(zz & 0xFFFFFFFFul) -
             int64_t(rr & 0xFFFFFFFFul);
      high += int64_t(xx >> 32) + int64_t(yy >> 32) + int64_t(zz >> 32) - int64_t(rr >> 32);
    }
    carry = low >> 32;
  }
  return carry < int64_t(0);
}

FN uint lowest_scale(uint bits, uint lowest) {
  uint scale = scale_of(bits);
  return mantissa_of(bits) != 0u && scale < lowest ? scale : lowest;
}
FN uint highest_scale(uint bits, uint highest) {
  uint scale = scale_of(bits);
  return mantissa_of(bits) != 0u && scale > highest ? scale : highest;
}

// Decides a pair stage by stage. Integers have as many words as the exponents of the eight inputs span: a difference
// takes span + 25 bits, and one bit more keeps the sum of three squares below the top.
FN Verdict decide_exact(vec4 a, vec4 b) {
  Verdict verdict = {false, STAGE_NONFINITE};
  if (!finite_sphere(a) || !finite_sphere(b)) return verdict;
  uint by_double = decide_double(a, b);
  verdict.collide = by_double == COLLIDE;
  verdict.stage = STAGE_DOUBLE;
  if (by_double != UNDECIDED) return verdict;
  uint base = lowest_scale(float_bits(a.x), lowest_scale(float_bits(a.y), lowest_scale(float_bits(a.z), 254u)));
  base = lowest_scale(float_bits(b.x), lowest_scale(float_bits(b.y), lowest_scale(float_bits(b.z), base)));
  base = lowest_scale(float_bits(a.w), lowest_scale(float_bits(b.w), base));
  uint top = highest_scale(float_bits(a.x), highest_scale(float_bits(a.y), highest_scale(float_bits(a.z), base)));
  top = highest_scale(float_bits(b.x), highest_scale(float_bits(b.y), highest_scale(float_bits(b.z), top)));
  top = highest_scale(float_bits(a.w), highest_scale(float_bits(b.w), top));
  uint words = (top - base + 57u) >> 5;
  Wide x = magnitude_of_sum(float_bits(a.x), float_bits(b.x) ^ 0x80000000u, base, words);
  Wide y = magnitude_of_sum(float_bits(a.y), float_bits(b.y) ^ 0x80000000u, base, words);
  Wide z = magnitude_of_sum(float_bits(a.z), float_bits(b.z) ^ 0x80000000u, base, words);
  Wide r = magnitude_of_sum(float_bits(a.w), float_bits(b.w), base, words);
  verdict.collide = squares_less(x, y, z, r, words);
  verdict.stage = words > 2u ? STAGE_WIDE : STAGE_INTEGER;
  return verdict;
}

// Runs all stages in order, for callers that decide a single pair.
FN Verdict decide_pair(vec4 a, vec4 b, float scale, float offset) {
  uint by_filter = filter_pair(a, b, scale, offset);
  Verdict verdict = {by_filter == COLLIDE, STAGE_FLOAT};
  if (by_filter != UNDECIDED) return verdict;
  return decide_exact(a, b);
}

// Whether x + y + z < 0, given the bits of three finite floats.
FN bool sum_negative(uint x, uint y, uint z) {
  int64_t carry = int64_t(0);
  for (uint k = 0u; k < 9u; ++k) {
    carry += signed_word(x, 1u, k) + signed_word(y, 1u, k) + signed_word(z, 1u, k);
    carry = carry >> 32;
  }
  return carry < int64_t(0);
}

#endif
