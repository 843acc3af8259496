// SPDX-License-Identifier: MIT
// A group adds up a tile of the table, for grid_scan.
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SCAN_BLOCK) grid_sums(Params p, KernelBuffers w) {
  __shared__ uint sum;
  uint lane = threadIdx.x;
  uint tile = p.first_bucket / SCAN_TILE + group_index(p);
  if (group_index(p) >= p.scan_tiles) return;
  if (lane == 0u) sum = 0u;
  __syncthreads();
  uint own = 0u;
  for (uint v = 0u; v < SCAN_VECTORS; ++v) {
    uvec4 counts = reinterpret_cast<const uvec4*>(w.cell)[tile * (SCAN_TILE / 4u) + v * SCAN_BLOCK + lane];
    own += counts.x + counts.y + counts.z + counts.w;
  }
  atomicAdd(&sum, own);
  __syncthreads();
  if (lane == 0u) w.tile_sum[tile] = sum;
}

Entry grid_sums_kernel(uint, Variant) { return reinterpret_cast<Entry>(&grid_sums); }

}  // namespace spherepair
