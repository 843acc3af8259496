#version 450
// SPDX-License-Identifier: MIT
// One thread per texel of one level: the greatest depth of what it covers, a pixel without a sphere being infinite.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_VISIBLE) restrict readonly buffer VisibleBuffer { uvec2 visible[]; };
layout(std430, binding = SLOT_PYRAMID) restrict buffer PyramidBuffer { uint pyramid[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(local_size_x = BLOCK) in;

uint greatest_of_pixels(uint x, uint y) {
  uint greatest = 0u;
  for (uint row = y * LEVEL_0; row < min((y + 1u) * LEVEL_0, v.height); ++row)
    for (uint column = x * LEVEL_0; column < min((x + 1u) * LEVEL_0, v.width); ++column)
      greatest = max(greatest, visible[row * v.width + column].y);
  return greatest;
}

uint greatest_of_texels(uint x, uint y) {
  uint below = v.level - 1u;
  uint width = texels_along(v.width, below);
  uint height = texels_along(v.height, below);
  uint greatest = 0u;
  for (uint row = y * 4u; row < min(y * 4u + 4u, height); ++row)
    for (uint column = x * 4u; column < min(x * 4u + 4u, width); ++column)
      greatest = max(greatest, pyramid[first_texel(below, v) + row * width + column]);
  return greatest;
}

void main() {
  uint texel = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (texel == 0u) {
    drawn[DRAWN_TILES_DONE] = drawn[DRAWN_TILES];
    drawn[DRAWN_CLUSTERS_DONE] = drawn[DRAWN_CLUSTERS];
  }
  uint width = texels_along(v.width, v.level);
  if (texel >= width * texels_along(v.height, v.level)) return;
  uint x = texel % width;
  uint y = texel / width;
  pyramid[first_texel(v.level, v) + texel] = v.level == 0u ? greatest_of_pixels(x, y) : greatest_of_texels(x, y);
}
