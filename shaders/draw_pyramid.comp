#version 450
// SPDX-License-Identifier: MIT
// One group per texel of level 1, one thread per row of a texel of level 0: the greatest depth of what each covers, a
// pixel without a sphere being infinite.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_VISIBLE) restrict readonly buffer VisibleBuffer { uvec2 visible[]; };
layout(std430, binding = SLOT_PYRAMID) restrict writeonly buffer PyramidBuffer { uint pyramid[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(local_size_x = BLOCK) in;
const uint side = LEVEL_1 / LEVEL_0;  // texels of level 0 along one of level 1
shared uint row_greatest[LEVEL_1 * side];
shared uint texel_greatest[side * side];

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (group_index() == 0u && lane == 0u) drawn[DRAWN_TILES_DONE] = drawn[DRAWN_TILES];
  uint width = texels_along(v.width, 1u);
  if (group_index() >= width * texels_along(v.height, 1u)) return;
  uint x = group_index() % width;
  uint y = group_index() / width;
  uint row = y * LEVEL_1 + lane / side;
  uint column = x * LEVEL_1 + lane % side * LEVEL_0;
  uint greatest = 0u;
  for (uint k = 0u; k < LEVEL_0; ++k)
    if (row < v.height && column + k < v.width) greatest = max(greatest, visible[row * v.width + column + k].y);
  row_greatest[lane] = greatest;
  barrier();
  uint x_0 = x * side + lane % side;
  uint y_0 = y * side + lane / side;
  if (lane < side * side) {
    greatest = 0u;
    for (uint k = 0u; k < LEVEL_0; ++k)
      greatest = max(greatest, row_greatest[(lane / side * LEVEL_0 + k) * side + lane % side]);
    texel_greatest[lane] = greatest;
    if (x_0 < texels_along(v.width, 0u) && y_0 < texels_along(v.height, 0u))
      pyramid[y_0 * texels_along(v.width, 0u) + x_0] = greatest;
  }
  barrier();
  if (lane != 0u) return;
  for (uint k = 1u; k < side * side; ++k) greatest = max(greatest, texel_greatest[k]);
  pyramid[first_texel(1u, v) + group_index()] = greatest;
}
