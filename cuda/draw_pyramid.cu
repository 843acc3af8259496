// SPDX-License-Identifier: MIT
// One thread per texel of one level: the greatest depth of what it covers, a pixel without a sphere being infinite.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline uint greatest_of_pixels(const World& w, const View& v, uint x, uint y) {
  uint greatest = 0u;
  for (uint row = y * LEVEL_0; row < min((y + 1u) * LEVEL_0, v.height); ++row)
    for (uint column = x * LEVEL_0; column < min((x + 1u) * LEVEL_0, v.width); ++column)
      greatest = max(greatest, w.visible[row * v.width + column].y);
  return greatest;
}

__device__ inline uint greatest_of_texels(const World& w, const View& v, uint x, uint y) {
  uint below = v.level - 1u;
  uint width = texels_along(v.width, below);
  uint height = texels_along(v.height, below);
  uint greatest = 0u;
  for (uint row = y * 4u; row < min(y * 4u + 4u, height); ++row)
    for (uint column = x * 4u; column < min(x * 4u + 4u, width); ++column)
      greatest = max(greatest, w.pyramid[first_texel(below, v) + row * width + column]);
  return greatest;
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_pyramid(Params p, World w, View v) {
  uint texel = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (texel == 0u) {
    w.drawn[DRAWN_TILES_DONE] = w.drawn[DRAWN_TILES];
    w.drawn[DRAWN_CLUSTERS_DONE] = w.drawn[DRAWN_CLUSTERS];
  }
  uint width = texels_along(v.width, v.level);
  if (texel >= width * texels_along(v.height, v.level)) return;
  uint x = texel % width;
  uint y = texel / width;
  w.pyramid[first_texel(v.level, v) + texel] =
      v.level == 0u ? greatest_of_pixels(w, v, x, y) : greatest_of_texels(w, v, x, y);
}

Entry draw_pyramid_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_pyramid); }

}  // namespace spherepair
