// SPDX-License-Identifier: MIT
// One group per tile of the table: sums it up, for grid_scan.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SCAN_BLOCK;

__global__ void __launch_bounds__(BLOCK) grid_sums(Params p, KernelBuffers buf) {
  __shared__ uint sum;
  const uvec4* cell = reinterpret_cast<const uvec4*>(buf.cell);
  uint lane = threadIdx.x;
  uint tile = p.sort.first_bucket / SCAN_TILE + group_index(p);
  if (group_index(p) >= p.sort.scan_tiles) return;
  if (lane == 0u) sum = 0u;
  __syncthreads();
  uint own = 0u;
  for (uint v = 0u; v < SCAN_VECTORS; ++v) {
    uvec4 counts = cell[tile * (SCAN_TILE / 4u) + v * BLOCK + lane];
    own += counts.x + counts.y + counts.z + counts.w;
  }
  atomicAdd(&sum, own);
  __syncthreads();
  if (lane == 0u) buf.tile_sum[tile] = sum;
}

Entry grid_sums_kernel(uint, Variant) { return reinterpret_cast<Entry>(&grid_sums); }

}  // namespace spherepair
