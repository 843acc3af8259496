// SPDX-License-Identifier: MIT
// One group per texel of level 2 of the hierarchical Z: reduces the depths of its pixels to texels of levels 0, 1
// and 2.
#include "common/shared/cluster.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = PYRAMID_BLOCK;

constexpr uint side = LEVEL_1 / LEVEL_0;  // texels across one of the next level, from level 0 to 1 and from 1 to 2
constexpr uint texels = side * side;      // texels of level 0 across one of level 2
constexpr uint pixels_each = LEVEL_2 * LEVEL_2 / BLOCK;  // pixels of a column that one thread reads

__device__ inline void put(const KernelBuffers& buf, const View& v, uint level, uint x, uint y, uvec2 texel) {
  uint width = texels_along(v.width, level);
  if (x < width && y < texels_along(v.height, level)) buf.pyramid[first_texel(level, v) + y * width + x] = texel;
}

__global__ void __launch_bounds__(BLOCK) draw_hiz_pyramid(Params p, KernelBuffers buf, View v) {
  __shared__ uvec2 columns[texels][LEVEL_2 + 1u];  // of pixels; the padding avoids bank conflicts
  __shared__ uvec2 texel_0[texels * texels];
  __shared__ uvec2 texel_1[side * side];
  static_assert(pixels_each % LEVEL_0 == 0u && LEVEL_2 == side * LEVEL_1);
  uint lane = threadIdx.x;
  if (group_index(p) == 0u && lane == 0u && v.phase != PHASE_FAR) buf.drawn[DRAWN_TILES_DONE] = buf.drawn[DRAWN_TILES];
  uint width = texels_along(v.width, 2u);
  uint x = group_index(p) % width;
  uint y = group_index(p) / width;
  uint column = lane % LEVEL_2;
  uint row = lane / LEVEL_2 * pixels_each;
  uint left = min(x * LEVEL_2 + column, v.width - 1u);  // clamped to the image's last pixels
  uint depths[pixels_each];
  for (uint k = 0u; k < pixels_each; ++k)
    depths[k] = buf.visible[min(y * LEVEL_2 + row + k, v.height - 1u) * v.width + left].y;
  uvec2 all;
  for (uint first = 0u; first < pixels_each; first += LEVEL_0) {
    all = texel_of_pixel(depths[first]);
    for (uint k = 1u; k < LEVEL_0; ++k) all = texel_of_both(all, texel_of_pixel(depths[first + k]));
    columns[(row + first) / LEVEL_0][column] = all;
  }
  __syncthreads();
  if (lane < texels * texels) {
    uint below = lane / texels;
    uint first = lane % texels * LEVEL_0;
    all = columns[below][first];
    for (uint k = 1u; k < LEVEL_0; ++k) all = texel_of_both(all, columns[below][first + k]);
    texel_0[lane] = all;
    put(buf, v, 0u, x * texels + lane % texels, y * texels + below, all);
  }
  __syncthreads();
  if (lane < side * side) {
    uint first = lane / side * side * side * side + lane % side * side;
    all = texel_0[first];
    for (uint k = 1u; k < side * side; ++k)
      all = texel_of_both(all, texel_0[first + k / side * side * side + k % side]);
    texel_1[lane] = all;
    put(buf, v, 1u, x * side + lane % side, y * side + lane / side, all);
  }
  __syncthreads();
  if (lane != 0u) return;
  for (uint k = 1u; k < side * side; ++k) all = texel_of_both(all, texel_1[k]);
  put(buf, v, 2u, x, y, all);
}

Entry draw_hiz_pyramid_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_hiz_pyramid); }

}  // namespace spherepair
