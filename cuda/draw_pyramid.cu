// SPDX-License-Identifier: MIT
// One group per texel of level 1, one thread per row of a texel of level 0: the depths of what each covers.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

constexpr uint side = LEVEL_1 / LEVEL_0;  // texels of level 0 along one of level 1

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_pyramid(Params p, World w, View v) {
  __shared__ uvec2 row_texel[LEVEL_1 * side];
  __shared__ uvec2 texel_in[side * side];
  static_assert(SERVICE_BLOCK == LEVEL_1 * side);
  uint lane = threadIdx.x;
  if (group_index(p) == 0u && lane == 0u && v.phase != PHASE_FAR) w.drawn[DRAWN_TILES_DONE] = w.drawn[DRAWN_TILES];
  uint width = texels_along(v.width, 1u);
  if (group_index(p) >= width * texels_along(v.height, 1u)) return;
  uint x = group_index(p) % width;
  uint y = group_index(p) / width;
  uint row = y * LEVEL_1 + lane / side;
  uint column = x * LEVEL_1 + lane % side * LEVEL_0;
  uvec2 all = {0u, 0u};
  for (uint k = 0u; k < LEVEL_0; ++k)
    if (row < v.height && column + k < v.width)
      all = texel_of_both(all, texel_of_pixel(w.visible[row * v.width + column + k].y));
  row_texel[lane] = all;
  __syncthreads();
  uint x_0 = x * side + lane % side;
  uint y_0 = y * side + lane / side;
  if (lane < side * side) {
    all = row_texel[lane / side * LEVEL_0 * side + lane % side];
    for (uint k = 1u; k < LEVEL_0; ++k)
      all = texel_of_both(all, row_texel[(lane / side * LEVEL_0 + k) * side + lane % side]);
    texel_in[lane] = all;
    if (x_0 < texels_along(v.width, 0u) && y_0 < texels_along(v.height, 0u))
      w.pyramid[y_0 * texels_along(v.width, 0u) + x_0] = all;
  }
  __syncthreads();
  if (lane != 0u) return;
  for (uint k = 1u; k < side * side; ++k) all = texel_of_both(all, texel_in[k]);
  w.pyramid[first_texel(1u, v) + group_index(p)] = all;
}

Entry draw_pyramid_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_pyramid); }

}  // namespace spherepair
