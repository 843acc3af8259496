// SPDX-License-Identifier: MIT
// Quotient and square root with the same bits as in real.h, but in a few operations instead of a loop of 25 iterations.
// A guess by the machine's own division, however it rounds, is corrected by the remainder, an integer.
#ifndef SPHEREPAIR_CONTACT_QUOTIENT_H
#define SPHEREPAIR_CONTACT_QUOTIENT_H

#include "common/shared/real.h"
#include "common/shared/round.h"

struct Digits {
  uint whole;  // 25 bits
  int rest;
};

// Returns floor(2^24 a/b) and the remainder for 2^23 <= b <= a < 2b, from a guess within 2^6. Remainders then fit into
// 32 bits, and so are right in arithmetic modulo 2^32.
FN Digits digits_of_quotient(uint a, uint b, uint guess) {
  Digits d = {guess, int((a << 24) - guess * b)};
  while (d.rest < 0) {
    d.whole -= 1u;
    d.rest += int(b);
  }
  while (d.rest >= int(b)) {
    d.whole += 1u;
    d.rest -= int(b);
  }
  return d;
}

// Returns floor(sqrt(2^25 x)) and the remainder of its square, for 2^23 <= x < 2^25, from a guess within 2^4.
FN Digits digits_of_root(uint x, uint guess) {
  Digits d = {guess, int((x << 25) - guess * guess)};
  while (d.rest < 0) {
    d.whole -= 1u;
    d.rest += int(2u * d.whole + 1u);
  }
  while (d.rest > int(2u * d.whole)) {
    d.rest -= int(2u * d.whole + 1u);
    d.whole += 1u;
  }
  return d;
}

// Returns the bits of quotient().
FN float corrected_quotient(float a, float b) {
  uint sign = (float_bits(a) ^ float_bits(b)) & 0x80000000u;
  if (exponent_field(a) == 0u) return 0.0f;
  if (exponent_field(b) == 0u) return bits_float(sign | 0x7F7FFFFFu);
  uint dividend = significand(a);
  uint divisor = significand(b);
  bool less = dividend < divisor;
  if (less) dividend = dividend << 1;
  EXACT float guess = (float(dividend) / float(divisor)) * 16777216.0f;
  Digits d = digits_of_quotient(dividend, divisor, uint(guess));
  int exponent = int(exponent_field(a)) - int(exponent_field(b)) + (less ? 126 : 127);
  return bits_float(sign | rounded_bits(d.whole, uint(d.rest), exponent));
}

// Returns the bits of square_root().
FN float corrected_root(float x) {
  if (!(x > 0.0f) || exponent_field(x) == 0u) return 0.0f;
  uint even = (exponent_field(x) & 1u) ^ 1u;
  uint radicand = significand(x) << even;
  EXACT float doubled = float(radicand) * 2.0f;
  float root = same_root(doubled);
  EXACT float guess = (root + doubled / root) * 2048.0f;
  Digits d = digits_of_root(radicand, uint(guess));
  int halved = (int(exponent_field(x)) - 175 - int(even)) / 2;  // exact
  return bits_float(rounded_bits(d.whole, uint(d.rest), 151 + halved));
}

#endif
