// SPDX-License-Identifier: MIT
// Arithmetic on float64 state. Quotients and square roots are fixed sequences of additions and multiplications from a
// float32 guess made of integers. They have the same bits everywhere and are within 2 ulp, not correctly rounded.
#ifndef SPHEREPAIR_WIDE_H
#define SPHEREPAIR_WIDE_H

#include "common/shared/real.h"

FN double constant(vec4 parts, double kind) {
  EXACT double two = double(parts.x) + double(parts.y);
  EXACT double three = two + double(parts.z);
  kind = three;
  return kind;
}
FN double widened(float x, double kind) {
  kind = double(x);
  return kind;
}
FN float nearest(double x) { return float(x); }
FN double snapped(double x) { return (double_high(x) & 0x7FFFFFFFu) < 0x3BF00000u ? bits_double(0u, 0u) : x; }  // 2^-64

FN bool below(double a, double b) { return a < b; }
FN double negated(double a) { return -a; }
FN double plus(double a, double b) {
  EXACT double sum = a + b;
  return sum;
}
FN double minus(double a, double b) {
  EXACT double difference = a - b;
  return difference;
}
FN double times(double a, double b) {
  EXACT double product = a * b;
  return product;
}

// Returns the float32 next to x on the side of 0: 0 below 2^-126, at most the largest float.
FN float truncated(double x) {
  uint high = double_high(x);
  uint exponent = (high >> 20) & 2047u;
  uint sign = high & 0x80000000u;
  if (exponent < 897u) return 0.0f;
  if (exponent > 1150u) return bits_float(sign | 0x7F7FFFFFu);
  uint fraction = ((high & 0xFFFFFu) << 3) | (double_low(x) >> 29);
  return bits_float(sign | ((exponent - 896u) << 23) | fraction);
}

// Returns a / b for 2^-120 < |b| < 2^120.
FN double quotient(double a, double b) {
  double guess = double(quotient(1.0f, truncated(b)));
  double two = double(2.0f);
  guess = times(guess, minus(two, times(b, guess)));
  guess = times(guess, minus(two, times(b, guess)));
  double result = times(a, guess);
  return plus(result, times(guess, minus(a, times(b, result))));
}

// Returns the square root for x < 2^120; 0 below 2^-126.
FN double square_root(double x) {
  float first = square_root(truncated(x));
  if (first == 0.0f) return bits_double(0u, 0u);
  double inverse = double(quotient(1.0f, first));
  double half_x = times(x, double(0.5f));
  double most = double(1.5f);
  inverse = times(inverse, minus(most, times(half_x, times(inverse, inverse))));
  inverse = times(inverse, minus(most, times(half_x, times(inverse, inverse))));
  double result = times(x, inverse);
  double rest = minus(x, times(result, result));
  return plus(result, times(times(inverse, double(0.5f)), rest));
}

#endif
