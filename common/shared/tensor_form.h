// SPDX-License-Identifier: MIT
// A sphere as 16 halves (float16) for tensor cores. With the halves A and B of two spheres, the sum over k of
// A[k] * B[k] is negative for every pair that collides, and for few others. This is the filter of collide_tensor.
//
// Centres are relative to the middle of all spheres and scaled by a power of two, so that |x|, |y|, |z|, r < 2^12. Then
//   G = (|a - b|^2 - (ra + rb)^2) / 2 = wa + wb - xa*xb - ya*yb - za*zb - ra*rb,   w = (x^2 + y^2 + z^2 - r^2) / 2,
// is negative where they collide. A coordinate is high + low, w is 2^10 times the sum of three halves, and the radius
// is one half, rounded up: three products a coordinate (low * low is left out), one of the radii, three for each w: 16.
//
// Bound on how far the sum may exceed G, with e = 2^-23, N = x^2 + y^2 + z^2 and P = Na + Nb + ra^2 + rb^2, which
// bounds the sum of all magnitudes. Halves are normal numbers or 0, so each product is exact in float32.
//   24 eP   the sum: tensor cores align a block of products, with the sum so far, to the greatest. They cut them 23
//           bits or more below it, then cut the result to 24 bits. In blocks of four (V100) that is 4 * (5 + 1) cuts
//           of eP; A100 has blocks of 8 and 24 bits, H100 one of 16 and 25 bits (Fasi, Higham, Mikaitis, Pranesh
//           2021; Khattak, Mikaitis 2025).
//    5 eP   centring, and what high + low leave of a coordinate: (2^-24 + 2^-22)|x|, so 5 e(Na + Nb) of |a - b|^2 / 2
//      eP   low * low, since |low| <= 2^-11 |x|
//  1.5 eP   float32 for N and w: 6 roundings of 2^-24 (N + r^2) / 2
// Together 31.5 eP, so 32e = 2^-18 of N + r^2 is taken off w. Halves below 2^-14 become 0, so that nothing depends on
// subnormal numbers: 2^-14 more of a coordinate, 3 of G in all, and 2^-4 of w: TENSOR_UNDERFLOW, for each sphere 2.
//
// The sum is stored as a half, rounded once. That keeps its sign, since a colliding pair's sum is below -0.5; sums that
// are too large become infinite. On an H200 the signs equal those of float32 sums, none of which is wrong by more than
// 0.25 e of the greatest product.
//
// Relative to the greatest extent X the margin is at most 2^-16 X^2: pairs within some 2^-8 X of each other may count
// as near, which only costs time. Spheres that are not finite or out of range are near every sphere.
#ifndef SPHEREPAIR_TENSOR_FORM_H
#define SPHEREPAIR_TENSOR_FORM_H

#include "common/shared/exact.h"

#define TENSOR_ROWS 1024         // spheres that a group of collide_tensor holds, a multiple of ...
#define TENSOR_COLUMNS 256       // ... the spheres of a tile that it tests them against
#define TENSOR_BLOCK 512         // threads of that group in CUDA
#define TENSOR_BOUNDS_GROUPS 64  // groups of tensor_bounds
#define TENSOR_RANGE 4096.0f     // upper limit of coordinates and radii
#define TENSOR_UNDERFLOW 2.0f
const uint HALF_1024 = 0x6400u;

// Returns the origin, and the scale in w: scaled coordinates are (position - origin) * w.
FN vec4 tensor_frame(vec4 low, vec4 high) {
  EXACT float x = low.x * 0.5f + high.x * 0.5f;
  EXACT float y = low.y * 0.5f + high.y * 0.5f;
  EXACT float z = low.z * 0.5f + high.z * 0.5f;
  EXACT float above_x = high.x - x;
  EXACT float above_y = high.y - y;
  EXACT float above_z = high.z - z;
  EXACT float below_x = x - low.x;
  EXACT float below_y = y - low.y;
  EXACT float below_z = z - low.z;
  float extent = larger(high.w, larger(above_x, larger(above_y, above_z)));
  extent = larger(extent, larger(below_x, larger(below_y, below_z)));
  uint exponent = extent > bits_float(0x0D800000u) ? float_bits(extent) >> 23 : 27u;  // at least 2^-100
  vec4 frame = {x, y, z, bits_float((265u - exponent) << 23)};                        // extent * w < 2^12
  return frame;
}

// Returns the nearest half, or 0 below 2^-14. |x| < 65520.
FN uint nearest_half(float x) {
  uint bits = float_bits(x);
  uint magnitude = bits & 0x7FFFFFFFu;
  if (magnitude < 0x38800000u) return 0u;
  magnitude += 0xFFFu + ((magnitude >> 13) & 1u);
  return ((bits >> 16) & 0x8000u) | ((magnitude - 0x38000000u) >> 13);
}
// Returns the least half that is not below |x|, at least 2^-14.
FN uint half_above(float x) {
  uint magnitude = float_bits(x) & 0x7FFFFFFFu;
  if (magnitude < 0x38800000u) magnitude = 0x38800000u;
  return (magnitude + 0x1FFFu - 0x38000000u) >> 13;
}
FN float half_value(uint h) {
  if ((h & 0x7FFFu) == 0u) return 0.0f;
  return bits_float(((h & 0x8000u) << 16) | (((h & 0x7FFFu) << 13) + 0x38000000u));
}

// A form, two halves a word, even k in the low half. It is in the order of matrix B; for matrix A see tensor_row_word.
struct TensorForm {
  uvec4 low, high;  // k = 0..7 and 8..15
};

FN TensorForm tensor_form_of(uint x, uint y, uint z, uint r, uint x_low, uint y_low, uint z_low, uint w, uint w2,
                             uint w3) {
  TensorForm form = {{x | (y << 16), z | (r << 16), x_low | (y_low << 16), x | (y << 16)},
                     {z_low | (HALF_1024 << 16), z | (w << 16), HALF_1024 | (HALF_1024 << 16), w2 | (w3 << 16)}};
  return form;
}

// Returns a form in which only w is not 0.
FN TensorForm tensor_form_of_w(float w) { return tensor_form_of(0u, 0u, 0u, 0u, 0u, 0u, 0u, nearest_half(w), 0u, 0u); }
FN TensorForm never_near_form() { return tensor_form_of_w(30000.0f); }
FN TensorForm always_near_form() { return tensor_form_of_w(-60000.0f); }

FN TensorForm tensor_form(vec4 a, vec4 frame) {
  EXACT float x = (a.x - frame.x) * frame.w;
  EXACT float y = (a.y - frame.y) * frame.w;
  EXACT float z = (a.z - frame.z) * frame.w;
  EXACT float radius = a.w * frame.w;
  bool fits = x < TENSOR_RANGE && x > -TENSOR_RANGE && y < TENSOR_RANGE && y > -TENSOR_RANGE && z < TENSOR_RANGE &&
              z > -TENSOR_RANGE && radius < TENSOR_RANGE && radius > -TENSOR_RANGE;
  if (!fits) return always_near_form();
  uint hx = nearest_half(x);
  uint hy = nearest_half(y);
  uint hz = nearest_half(z);
  EXACT float rest_x = x - half_value(hx);
  EXACT float rest_y = y - half_value(hy);
  EXACT float rest_z = z - half_value(hz);
  uint lx = nearest_half(rest_x);
  uint ly = nearest_half(rest_y);
  uint lz = nearest_half(rest_z);
  uint hr = half_above(radius);
  x = half_value(hx) + half_value(lx);
  y = half_value(hy) + half_value(ly);
  z = half_value(hz) + half_value(lz);
  float r = half_value(hr);
  EXACT float xx = x * x;
  EXACT float norm = multiply_add(z, z, multiply_add(y, y, xx));
  EXACT float half_norm = norm * bits_float(0x3EFFFF80u);                              // (1 - 2^-17) / 2
  EXACT float reach = (r * r) * bits_float(0x3F000040u);                               // (1 + 2^-17) / 2
  EXACT float w = ((half_norm - reach) - TENSOR_UNDERFLOW) * bits_float(0x3A800000u);  // 2^-10
  uint w1 = nearest_half(w);
  w = w - half_value(w1);
  uint w2 = nearest_half(w);
  w = w - half_value(w2);
  return tensor_form_of(hx, hy, hz, hr, lx, ly, lz, w1, w2, nearest_half(w));
}

// Returns which word of the same sphere's form becomes word `word` of matrix A, ...
FN uint tensor_row_source(uint word) { return word < 2u ? word : word ^ 1u; }
// ... and the signs to flip in it.
FN uint tensor_row_signs(uint word) { return word < 4u ? 0x80008000u : word < 6u ? 0x8000u : 0u; }

// Returns the number of tiles of TENSOR_ROWS x TENSOR_COLUMNS pairs; each block of rows begins at its first row.
FN uint64_t tensor_tiles(uint64_t n) {
  uint64_t blocks = (n + uint64_t(TENSOR_ROWS - 1)) / uint64_t(TENSOR_ROWS);
  uint64_t columns = (n + uint64_t(TENSOR_COLUMNS - 1)) / uint64_t(TENSOR_COLUMNS);
  return blocks * columns - uint64_t(TENSOR_ROWS / TENSOR_COLUMNS) * (blocks * (blocks - uint64_t(1)) / uint64_t(2));
}

#endif
