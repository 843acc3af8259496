// SPDX-License-Identifier: MIT
// One thread per four cells or one bucket: clears the counts, and the totals.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) grid_clear(Params p, KernelBuffers buf) {
  uvec4* cell = reinterpret_cast<uvec4*>(buf.cell);
  uint k = group_index(p) * BLOCK + threadIdx.x;
  if (p.sort.buckets == 0u && k <= (p.grid.cell_slots + 1u) / 4u) cell[k] = uvec4{0u, 0u, 0u, 0u};
  if (k < SUMMARY_SLOTS * SUMMARY_WORDS) buf.summary[k] = 0u;
  if (k < p.sort.bucket_words) buf.bucket_cursor[k] = 0u;
}

Entry grid_clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&grid_clear); }

}  // namespace spherepair
