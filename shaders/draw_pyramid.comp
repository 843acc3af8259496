#version 450
// SPDX-License-Identifier: MIT
// One group per texel of level 1, one thread per row of a texel of level 0: the depths of what each covers.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_VISIBLE) restrict readonly buffer VisibleBuffer { uvec2 visible[]; };
layout(std430, binding = SLOT_PYRAMID) restrict writeonly buffer PyramidBuffer { uvec2 pyramid[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(local_size_x = BLOCK) in;
const uint side = LEVEL_1 / LEVEL_0;  // texels of level 0 along one of level 1
shared uvec2 row_texel[LEVEL_1 * side];
shared uvec2 texel_in[side * side];

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (group_index() == 0u && lane == 0u && v.phase != PHASE_FAR) drawn[DRAWN_TILES_DONE] = drawn[DRAWN_TILES];
  uint width = texels_along(v.width, 1u);
  if (group_index() >= width * texels_along(v.height, 1u)) return;
  uint x = group_index() % width;
  uint y = group_index() / width;
  uint row = y * LEVEL_1 + lane / side;
  uint column = x * LEVEL_1 + lane % side * LEVEL_0;
  uvec2 all = {0u, 0u};
  for (uint k = 0u; k < LEVEL_0; ++k)
    if (row < v.height && column + k < v.width)
      all = texel_of_both(all, texel_of_pixel(visible[row * v.width + column + k].y));
  row_texel[lane] = all;
  barrier();
  uint x_0 = x * side + lane % side;
  uint y_0 = y * side + lane / side;
  if (lane < side * side) {
    all = row_texel[lane / side * LEVEL_0 * side + lane % side];
    for (uint k = 1u; k < LEVEL_0; ++k)
      all = texel_of_both(all, row_texel[(lane / side * LEVEL_0 + k) * side + lane % side]);
    texel_in[lane] = all;
    if (x_0 < texels_along(v.width, 0u) && y_0 < texels_along(v.height, 0u))
      pyramid[y_0 * texels_along(v.width, 0u) + x_0] = all;
  }
  barrier();
  if (lane != 0u) return;
  for (uint k = 1u; k < side * side; ++k) all = texel_of_both(all, texel_in[k]);
  pyramid[first_texel(1u, v) + group_index()] = all;
}
