// SPDX-License-Identifier: MIT
// One group per texel of level 2, four threads per texel of level 0: the depths of what each covers.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

constexpr uint side = LEVEL_1 / LEVEL_0;  // texels of level 0 along one of level 1, and of that along one of level 2
constexpr uint threads_each = 4u;         // that share a texel of level 0
constexpr uint rows_each = LEVEL_0 / threads_each;

__device__ inline void put(const World& w, const View& v, uint level, uint x, uint y, uvec2 texel) {
  uint width = texels_along(v.width, level);
  if (x < width && y < texels_along(v.height, level)) w.pyramid[first_texel(level, v) + y * width + x] = texel;
}

__global__ void __launch_bounds__(PYRAMID_BLOCK) draw_pyramid(Params p, World w, View v) {
  __shared__ uvec2 rows[PYRAMID_BLOCK];
  __shared__ uvec2 texel_0[PYRAMID_BLOCK / threads_each];
  __shared__ uvec2 texel_1[side * side];
  static_assert(PYRAMID_BLOCK == threads_each * side * side * side * side && LEVEL_2 == side * LEVEL_1);
  uint lane = threadIdx.x;
  if (group_index(p) == 0u && lane == 0u && v.phase != PHASE_FAR) w.drawn[DRAWN_TILES_DONE] = w.drawn[DRAWN_TILES];
  uint width = texels_along(v.width, 2u);
  uint x = group_index(p) % width;
  uint y = group_index(p) / width;
  uint own = lane / threads_each;
  uint column = x * LEVEL_2 + own % (side * side) * LEVEL_0;
  uint row = y * LEVEL_2 + own / (side * side) * LEVEL_0 + lane % threads_each * rows_each;
  uvec2 all = {0u, 0u};
  for (uint k = 0u; k < rows_each * LEVEL_0; ++k)
    if (row + k / LEVEL_0 < v.height && column + k % LEVEL_0 < v.width)
      all = texel_of_both(all, texel_of_pixel(w.visible[(row + k / LEVEL_0) * v.width + column + k % LEVEL_0].y));
  rows[lane] = all;
  __syncthreads();
  if (lane < side * side * side * side) {
    all = rows[lane * threads_each];
    for (uint k = 1u; k < threads_each; ++k) all = texel_of_both(all, rows[lane * threads_each + k]);
    texel_0[lane] = all;
    put(w, v, 0u, x * side * side + lane % (side * side), y * side * side + lane / (side * side), all);
  }
  __syncthreads();
  if (lane < side * side) {
    uint first = lane / side * side * side * side + lane % side * side;
    all = texel_0[first];
    for (uint k = 1u; k < side * side; ++k)
      all = texel_of_both(all, texel_0[first + k / side * side * side + k % side]);
    texel_1[lane] = all;
    put(w, v, 1u, x * side + lane % side, y * side + lane / side, all);
  }
  __syncthreads();
  if (lane != 0u) return;
  for (uint k = 1u; k < side * side; ++k) all = texel_of_both(all, texel_1[k]);
  put(w, v, 2u, x, y, all);
}

Entry draw_pyramid_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_pyramid); }

}  // namespace spherepair
