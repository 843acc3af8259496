// SPDX-License-Identifier: MIT
// One group per texel of level 1, one thread per row of a texel of level 0: the greatest depth of what each covers, a
// pixel without a sphere being infinite.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

constexpr uint side = LEVEL_1 / LEVEL_0;  // texels of level 0 along one of level 1

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_pyramid(Params p, World w, View v) {
  __shared__ uint row_greatest[LEVEL_1 * side];
  __shared__ uint texel_greatest[side * side];
  static_assert(SERVICE_BLOCK == LEVEL_1 * side);
  uint lane = threadIdx.x;
  if (group_index(p) == 0u && lane == 0u) w.drawn[DRAWN_TILES_DONE] = w.drawn[DRAWN_TILES];
  uint width = texels_along(v.width, 1u);
  if (group_index(p) >= width * texels_along(v.height, 1u)) return;
  uint x = group_index(p) % width;
  uint y = group_index(p) / width;
  uint row = y * LEVEL_1 + lane / side;
  uint column = x * LEVEL_1 + lane % side * LEVEL_0;
  uint greatest = 0u;
  for (uint k = 0u; k < LEVEL_0; ++k)
    if (row < v.height && column + k < v.width) greatest = max(greatest, w.visible[row * v.width + column + k].y);
  row_greatest[lane] = greatest;
  __syncthreads();
  uint x_0 = x * side + lane % side;
  uint y_0 = y * side + lane / side;
  if (lane < side * side) {
    greatest = 0u;
    for (uint k = 0u; k < LEVEL_0; ++k)
      greatest = max(greatest, row_greatest[(lane / side * LEVEL_0 + k) * side + lane % side]);
    texel_greatest[lane] = greatest;
    if (x_0 < texels_along(v.width, 0u) && y_0 < texels_along(v.height, 0u))
      w.pyramid[y_0 * texels_along(v.width, 0u) + x_0] = greatest;
  }
  __syncthreads();
  if (lane != 0u) return;
  for (uint k = 1u; k < side * side; ++k) greatest = max(greatest, texel_greatest[k]);
  w.pyramid[first_texel(1u, v) + group_index(p)] = greatest;
}

Entry draw_pyramid_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_pyramid); }

}  // namespace spherepair
