// SPDX-License-Identifier: MIT
// Compensated numbers: the unevaluated sum of two floats, about 48 bits, after Dekker (1971) and Knuth. They need float
// additions and multiplications that are neither fused nor simplified.
#ifndef SPHEREPAIR_TWO_H
#define SPHEREPAIR_TWO_H

#include "common/shared/real.h"

struct Two {
  float hi, lo;  // |lo| is at most half an ulp of hi
};

FN Two constant(vec4 parts, Two kind) {
  kind.hi = parts.x;
  kind.lo = parts.y;
  return kind;
}
FN Two widened(float x, Two kind) {
  kind.hi = x;
  kind.lo = 0.0f;
  return kind;
}
FN float nearest(Two x) { return x.hi; }
FN Two snapped(Two x) {
  Two zero = {0.0f, 0.0f};
  if (snap(x.hi) == 0.0f) return zero;
  return x;
}
FN bool below(Two a, Two b) { return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo); }
FN Two negated(Two a) {
  Two turned = {-a.hi, -a.lo};
  return turned;
}

// Return a + b exactly; the second needs |a| >= |b| or a = 0.
FN Two exact_sum(float a, float b) {
  EXACT float sum = a + b;
  EXACT float from_b = sum - a;
  EXACT float from_a = sum - from_b;
  EXACT float error_b = b - from_b;
  EXACT float error_a = a - from_a;
  EXACT float error = error_a + error_b;
  Two both = {sum, error};
  return both;
}
FN Two ordered_sum(float a, float b) {
  EXACT float sum = a + b;
  EXACT float from_b = sum - a;
  EXACT float error = b - from_b;
  Two both = {sum, error};
  return both;
}

// Returns the upper half of a's bits; the lower half is a minus it.
FN float upper_half(float a) {
  EXACT float shifted = a * 4097.0f;
  EXACT float rest = shifted - a;
  EXACT float upper = shifted - rest;
  return upper;
}

// Returns a * b exactly, unless it is below 2^-72, where halves of the factors would give denormal products.
FN Two exact_product(float a, float b) {
  float product = times(a, b);
  Two rough = {product, 0.0f};
  if ((float_bits(product) & 0x7FFFFFFFu) < 0x1B800000u) return rough;
  float a_upper = upper_half(a);
  float b_upper = upper_half(b);
  EXACT float a_lower = a - a_upper;
  EXACT float b_lower = b - b_upper;
  EXACT float upper = a_upper * b_upper;
  EXACT float cross_a = a_upper * b_lower;
  EXACT float cross_b = a_lower * b_upper;
  EXACT float lower = a_lower * b_lower;
  EXACT float error_1 = upper - product;
  EXACT float error_2 = error_1 + cross_a;
  EXACT float error_3 = error_2 + cross_b;
  EXACT float error = error_3 + lower;
  Two both = {product, error};
  return both;
}

FN Two plus(Two a, Two b) {
  Two high = exact_sum(a.hi, b.hi);
  Two low = exact_sum(a.lo, b.lo);
  Two sum = ordered_sum(high.hi, plus(high.lo, low.hi));
  return ordered_sum(sum.hi, plus(sum.lo, low.lo));
}
FN Two minus(Two a, Two b) { return plus(a, negated(b)); }
FN Two times(Two a, Two b) {
  Two product = exact_product(a.hi, b.hi);
  float cross = plus(times(a.hi, b.lo), times(a.lo, b.hi));
  return ordered_sum(product.hi, plus(product.lo, cross));
}

// Both take the correctly rounded float and correct it once: errors below 2^-45 of the result.
FN Two quotient(Two a, Two b) {
  float first = quotient(a.hi, b.hi);
  Two rest = minus(a, times(b, widened(first, b)));
  return ordered_sum(first, quotient(rest.hi, b.hi));
}
FN Two square_root(Two x) {
  float first = square_root(x.hi);
  Two rest = minus(x, exact_product(first, first));
  return ordered_sum(first, quotient(rest.hi, plus(first, first)));
}

#endif
