// SPDX-License-Identifier: MIT
// Arithmetic on float state, with the same bits on every machine. It is the first of three number types (real.h, two.h,
// wide.h) for which motion is written once; functions have the same names for all three. No float here is ever
// denormal: products below 2^-100 become +0, so all values and sums are multiples of 2^-123. Quotients and square roots
// are built from integers, one bit an iteration, and correctly rounded, unlike GLSL's own.
#ifndef SPHEREPAIR_REAL_H
#define SPHEREPAIR_REAL_H

#include "common/shared/portable.h"

// Convert a host constant, or a float, to the number type of the last argument, whose value is ignored. The sum of a
// constant's three floats holds a double's 53 bits.
FN float constant(vec4 parts, float kind) {
  kind = parts.x;
  return kind;
}
FN float widened(float x, float kind) {
  kind = x;
  return kind;
}
FN float nearest(float x) { return x; }

// Replace components below 2^-64, and -0, by +0, so that flushed denormals make no difference.
FN float snap(float x) { return (float_bits(x) & 0x7FFFFFFFu) < 0x1F800000u ? 0.0f : x; }
FN float snapped(float x) { return snap(x); }

FN bool below(float a, float b) { return a < b; }
FN float negated(float a) { return -a; }
FN float plus(float a, float b) {
  EXACT float sum = a + b;
  return sum;
}
FN float minus(float a, float b) {
  EXACT float difference = a - b;
  return difference;
}
FN float times(float a, float b) {
  EXACT float product = a * b;
  return (float_bits(product) & 0x7FFFFFFFu) < 0x0D800000u ? 0.0f : product;
}

FN uint significand(float x) { return (float_bits(x) & 0x7FFFFFu) | 0x800000u; }
FN uint exponent_field(float x) { return (float_bits(x) >> 23) & 255u; }

// Returns the bits of a positive float. digits: 25 bits of its value, the last of which decides the rounding together
// with `rest`; exponent: the exponent field of the first. Values below 2^-126 become 0, values above all floats the
// largest float.
FN uint rounded_bits(uint digits, uint rest, int exponent) {
  if (exponent < 1) return 0u;
  if (exponent > 254) return 0x7F7FFFFFu;
  uint whole = digits >> 1;
  bool up = (digits & 1u) != 0u && (rest != 0u || (whole & 1u) != 0u);
  uint bits = (uint(exponent) << 23) + (whole - 0x800000u) + (up ? 1u : 0u);
  return bits < 0x7F800000u ? bits : 0x7F7FFFFFu;
}

// Returns a / b, correctly rounded. Denormals count as 0; a / 0 is the largest float.
FN float quotient(float a, float b) {
  uint sign = (float_bits(a) ^ float_bits(b)) & 0x80000000u;
  if (exponent_field(a) == 0u) return 0.0f;
  if (exponent_field(b) == 0u) return bits_float(sign | 0x7F7FFFFFu);
  int exponent = int(exponent_field(a)) - int(exponent_field(b)) + 127;
  uint rest = significand(a);
  uint divisor = significand(b);
  if (rest < divisor) {
    rest = rest << 1;
    exponent -= 1;
  }
  uint digits = 0u;
  for (uint turn = 0u; turn < 25u; ++turn) {
    bool fits = rest >= divisor;
    digits = (digits << 1) | (fits ? 1u : 0u);
    rest = (fits ? rest - divisor : rest) << 1;
  }
  return bits_float(sign | rounded_bits(digits, rest, exponent));
}

// Returns the square root, correctly rounded; 0 if x is not positive.
FN float square_root(float x) {
  if (!(x > 0.0f) || exponent_field(x) == 0u) return 0.0f;
  uint even = (exponent_field(x) & 1u) ^ 1u;
  uint next = significand(x) << (7u + even);  // read two bits an iteration
  uint rest = 0u;
  uint digits = 0u;
  for (uint turn = 0u; turn < 25u; ++turn) {
    rest = (rest << 2) | (next >> 30);
    next = next << 2;
    uint trial = (digits << 2) | 1u;
    bool fits = rest >= trial;
    digits = (digits << 1) | (fits ? 1u : 0u);
    rest = fits ? rest - trial : rest;
  }
  int halved = (int(exponent_field(x)) - 175 - int(even)) / 2;  // exact
  return bits_float(rounded_bits(digits, rest, 151 + halved));
}

#endif
