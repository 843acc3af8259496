// SPDX-License-Identifier: MIT
// Fixed-point state: conversions between 64-bit integers and float32, each correctly rounded by integer operations, so
// that they have the same bits in every language. All are odd: f(-x) = -f(x).
#ifndef SPHEREPAIR_FIXED_H
#define SPHEREPAIR_FIXED_H

#include "common/shared/real.h"

const int64_t MOST_UNITS = 0x2000000000000000l;  // 2^61: positions are below it

FN uint64_t magnitude(int64_t x) { return uint64_t(x < 0l ? -x : x); }
FN int64_t with_sign(uint64_t x, int64_t sign) { return sign < 0l ? -int64_t(x) : int64_t(x); }

FN float power_of_two(int exponent) { return bits_float(uint(exponent + 127) << 23); }  // -126..127

// Returns the nearest float, ties to even.
FN float float_of(int64_t x) {
  uint64_t whole = magnitude(x);
  uint sign = x < 0l ? 0x80000000u : 0u;
  uint high = uint(whole >> 32);
  uint top = high != 0u ? 32u + highest_bit(high) : highest_bit(uint(whole & 0xFFFFFFFFul) | 1u);
  uint64_t digits = whole << (63u - top);  // its highest set bit is bit 63
  uint kept = uint(digits >> 40);
  uint up = (digits & 0xFFFFFFFFFFul) + uint64_t(kept & 1u) > 0x8000000000ul ? 1u : 0u;
  uint bits = (((127u + top) << 23) + (kept - 0x800000u) + up) | sign;
  return bits_float(whole != 0ul ? bits : 0u);
}

// Returns the nearest integer, ties to even, for |x| < 2^61; larger numbers and NaN become +-2^61.
FN int64_t integer_of(float x) {
  uint bits = float_bits(x) & 0x7FFFFFFFu;
  int64_t sign = float_bits(x) == bits ? 1l : -1l;
  if (bits >= 0x5E000000u) return with_sign(uint64_t(MOST_UNITS), sign);
  if (bits >= 0x4B000000u) return with_sign(uint64_t(significand(x)) << ((bits >> 23) - 150u), sign);  // from 2^23 on
  EXACT float sum = bits_float(bits) + 8388608.0f;
  EXACT float whole = sum - 8388608.0f;
  return with_sign(uint64_t(uint(whole)), sign);
}

// Returns x / 2^bits, rounded towards 0.
FN int64_t shifted(int64_t x, int bits) { return with_sign(magnitude(x) >> uint(bits), x); }

// Returns x * factor, rounded once, halves away from 0. 2^-72 <= factor < 2^22, and the product below 2^61.
FN int64_t scaled(int64_t x, float factor) {
  uint64_t whole = magnitude(x);
  uint64_t digits = uint64_t(significand(factor));
  uint below_point = 150u - exponent_field(factor);
  uint64_t high = (whole >> 32) * digits;
  uint64_t low = (whole & 0xFFFFFFFFul) * digits;
  if (below_point <= 32u) {
    return with_sign((high << (32u - below_point)) + ((low + (1ul << (below_point - 1u))) >> below_point), x);
  }
  uint shift = below_point - 32u;
  return with_sign((high + (low >> 32) + (1ul << (shift - 1u))) >> shift, x);
}

#endif
