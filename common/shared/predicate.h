// SPDX-License-Identifier: MIT
// The float32 filter of the exact collision predicate. Spheres a and b collide when S < Q, S = |a - b|^2 and
// Q = (a.w + b.w)^2, in real arithmetic on the float32 inputs (the paper's equation 2); tangent spheres do not collide.
// The filter returns APART or COLLIDE only if rounding cannot have changed the result, else UNDECIDED, for exact.h to
// decide. It does not rely on whether a compiler fuses operations or in which direction it rounds.
#ifndef SPHEREPAIR_PREDICATE_H
#define SPHEREPAIR_PREDICATE_H

#include "common/shared/portable.h"

const uint APART = 0u;
const uint COLLIDE = 1u;
const uint UNDECIDED = 2u;

FN float squared_distance(vec4 a, vec4 b) {
  EXACT float dx = a.x - b.x;
  EXACT float dy = a.y - b.y;
  EXACT float dz = a.z - b.z;
  EXACT float xx = dx * dx;
  EXACT float s = multiply_add(dz, dz, multiply_add(dy, dy, xx));
  return s;
}

// Decides the pair if its error bound allows. With u = 2^-24, s carries at most 5 rounding factors, q 3 and the bound
// 2, so scale = 1 + 24u decides safely; offset = 2^-100 absorbs underflow and flushed denormals. scale = 1 and
// offset = 0 make it the naive test. A q that overflowed may come from an infinite radius, which never collides, so the
// pair stays undecided.
FN uint filter_pair(vec4 a, vec4 b, float scale, float offset) {
  EXACT float s = squared_distance(a, b);
  EXACT float r = a.w + b.w;
  EXACT float q = r * r;
  EXACT float apart_above = multiply_add(q, scale, offset);
  EXACT float collide_above = multiply_add(s, scale, offset);
  if (s > apart_above) return APART;
  if (q > collide_above && q <= bits_float(0x7F7FFFFFu)) return COLLIDE;
  return UNDECIDED;
}

// Whether filter_pair returns anything but APART.
FN bool filter_near(vec4 a, vec4 b, float scale, float offset) {
  EXACT float s = squared_distance(a, b);
  EXACT float r = a.w + b.w;
  EXACT float q = r * r;
  EXACT float apart_above = multiply_add(q, scale, offset);
  return !(s > apart_above);
}

// Filters pairs of equal radii. The host rounds Q(1 + 12u) and Q(1 - 12u) outward once, and no radius is loaded.
FN uint filter_equal(float s, float apart_above, float collide_below) {
  if (s > apart_above) return APART;
  if (s < collide_below) return COLLIDE;
  return UNDECIDED;
}

// Returns a sphere relative to an origin, for the Gram form of the test. Spheres a and b can only collide if
//   a.x*b.x + a.y*b.y + a.z*b.z [+ ra*rb] >= a.w + b.w,   w = N(1 - k)/2 - share*(r^2(1 + k) + T),   N = |centre|^2,
// which costs three fused operations and a compare instead of seven instructions. With any origin, any rounding
// direction and e = 2^-23 per operation: centring moves a distance by at most 4e(Na + Nb) of its square, the chain adds
// 4e(Na/2 + Nb + r^2), w itself 6e of its terms; k = 32e covers their sum with room, T = 2^-99 covers underflow.
// share is 1/2 if the product of radii is added. For equal radii it is not added: share is then 1 for both, or 2 and 0,
// and w is never negative for 0. Numbers that could overflow or are not finite become a form that can collide with
// everything, so that the filter decides.
FN vec4 gram_form(vec4 a, vec4 origin, float share) {
  EXACT float x = a.x - origin.x;
  EXACT float y = a.y - origin.y;
  EXACT float z = a.z - origin.z;
  EXACT float xx = x * x;
  EXACT float norm = multiply_add(z, z, multiply_add(y, y, xx));
  EXACT float rr = a.w * a.w;
  EXACT float reach = rr * bits_float(0x3F800020u) + bits_float(0x0E000000u);  // r^2(1 + 2^-18) + 2^-99
  EXACT float half_norm = norm * bits_float(0x3EFFFFC0u);                      // (1 - 2^-18) / 2
  EXACT float w = half_norm - share * reach;
  bool small = norm < bits_float(0x71800000u) && rr < bits_float(0x71800000u);  // 2^100
  if (!small) {
    x = 0.0f;
    y = 0.0f;
    z = 0.0f;
    w = share == 0.0f ? bits_float(0x80000000u) : bits_float(0xFE800000u);  // -0, the least as an integer; -2^126
  }
  vec4 form = {x, y, z, w};
  return form;
}

// Returns the product of forms a and b, where minus_w is -a.w. If it is below b.w the spheres cannot collide. If b's
// share is 0, the bits of both compare as signed integers do, so one compare serves the greatest product of several a.
FN float gram_product(float ax, float ay, float az, float minus_w, vec4 b) {
  EXACT float product = multiply_add(ax, b.x, multiply_add(ay, b.y, multiply_add(az, b.z, minus_w)));
  return product;
}

#endif
