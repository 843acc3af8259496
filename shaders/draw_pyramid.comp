#version 450
// SPDX-License-Identifier: MIT
// One group per texel of level 2, four threads per texel of level 0: the depths of what each covers.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_VISIBLE) restrict readonly buffer VisibleBuffer { uvec2 visible[]; };
layout(std430, binding = SLOT_PYRAMID) restrict writeonly buffer PyramidBuffer { uvec2 pyramid[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(local_size_x = BLOCK) in;
const uint side = LEVEL_1 / LEVEL_0;  // texels of level 0 along one of level 1, and of that along one of level 2
const uint threads_each = 4u;         // that share a texel of level 0
const uint rows_each = LEVEL_0 / threads_each;
shared uvec2 rows[BLOCK];
shared uvec2 texel_0[BLOCK / threads_each];
shared uvec2 texel_1[side * side];

void put(uint level, uint x, uint y, uvec2 texel) {
  uint width = texels_along(v.width, level);
  if (x < width && y < texels_along(v.height, level)) pyramid[first_texel(level, v) + y * width + x] = texel;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (group_index() == 0u && lane == 0u && v.phase != PHASE_FAR) drawn[DRAWN_TILES_DONE] = drawn[DRAWN_TILES];
  uint width = texels_along(v.width, 2u);
  uint x = group_index() % width;
  uint y = group_index() / width;
  uint own = lane / threads_each;
  uint column = x * LEVEL_2 + own % (side * side) * LEVEL_0;
  uint row = y * LEVEL_2 + own / (side * side) * LEVEL_0 + lane % threads_each * rows_each;
  uvec2 all = {0u, 0u};
  for (uint k = 0u; k < rows_each * LEVEL_0; ++k)
    if (row + k / LEVEL_0 < v.height && column + k % LEVEL_0 < v.width)
      all = texel_of_both(all, texel_of_pixel(visible[(row + k / LEVEL_0) * v.width + column + k % LEVEL_0].y));
  rows[lane] = all;
  barrier();
  if (lane < side * side * side * side) {
    all = rows[lane * threads_each];
    for (uint k = 1u; k < threads_each; ++k) all = texel_of_both(all, rows[lane * threads_each + k]);
    texel_0[lane] = all;
    put(0u, x * side * side + lane % (side * side), y * side * side + lane / (side * side), all);
  }
  barrier();
  if (lane < side * side) {
    uint first = lane / side * side * side * side + lane % side * side;
    all = texel_0[first];
    for (uint k = 1u; k < side * side; ++k)
      all = texel_of_both(all, texel_0[first + k / side * side * side + k % side]);
    texel_1[lane] = all;
    put(1u, x * side + lane % side, y * side + lane / side, all);
  }
  barrier();
  if (lane != 0u) return;
  for (uint k = 1u; k < side * side; ++k) all = texel_of_both(all, texel_1[k]);
  put(2u, x, y, all);
}
