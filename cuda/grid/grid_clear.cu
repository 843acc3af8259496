// SPDX-License-Identifier: MIT
// One thread per four cells or one bucket: no sphere is counted yet, no result is found.
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) grid_clear(Params p, KernelBuffers w) {
  uint k = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (p.buckets == 0u && k <= (p.cell_slots + 1u) / 4u) reinterpret_cast<uvec4*>(w.cell)[k] = uvec4{0u, 0u, 0u, 0u};
  if (k < SUMMARY_SLOTS * SUMMARY_WORDS) w.summary[k] = 0u;
  if (k < p.bucket_words) w.bucket_cursor[k] = 0u;
}

Entry grid_clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&grid_clear); }

}  // namespace spherepair
