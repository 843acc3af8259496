#version 450
// SPDX-License-Identifier: MIT
// One group per texel of level 2 of the hierarchical Z: reduces the depths of its pixels to texels of levels 0, 1
// and 2.
#include "shaders/draw/view.glsl"
#include "shaders/kernels.glsl"
#include "common/shared/cluster.h"

layout(std430, binding = SLOT_VISIBLE) restrict readonly buffer VisibleBuffer { uvec2 visible[]; };
layout(std430, binding = SLOT_PYRAMID) restrict writeonly buffer PyramidBuffer { uvec2 pyramid[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(local_size_x = BLOCK) in;
const uint side = LEVEL_1 / LEVEL_0;  // texels across one of the next level, from level 0 to 1 and from 1 to 2
const uint texels = side * side;      // texels of level 0 across one of level 2
const uint pixels_each = LEVEL_2 * LEVEL_2 / BLOCK;  // pixels of a column that one thread reads
shared uvec2 columns[texels][LEVEL_2 + 1u];          // of pixels; the padding avoids bank conflicts
shared uvec2 texel_0[texels * texels];
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
  uint column = lane % LEVEL_2;
  uint row = lane / LEVEL_2 * pixels_each;
  uint left = min(x * LEVEL_2 + column, v.width - 1u);  // clamped to the image's last pixels
  uint depths[pixels_each];
  for (uint k = 0u; k < pixels_each; ++k)
    depths[k] = visible[min(y * LEVEL_2 + row + k, v.height - 1u) * v.width + left].y;
  uvec2 all;
  for (uint first = 0u; first < pixels_each; first += LEVEL_0) {
    all = texel_of_pixel(depths[first]);
    for (uint k = 1u; k < LEVEL_0; ++k) all = texel_of_both(all, texel_of_pixel(depths[first + k]));
    columns[(row + first) / LEVEL_0][column] = all;
  }
  barrier();
  if (lane < texels * texels) {
    uint below = lane / texels;
    uint first = lane % texels * LEVEL_0;
    all = columns[below][first];
    for (uint k = 1u; k < LEVEL_0; ++k) all = texel_of_both(all, columns[below][first + k]);
    texel_0[lane] = all;
    put(0u, x * texels + lane % texels, y * texels + below, all);
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
