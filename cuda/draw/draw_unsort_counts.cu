// SPDX-License-Identifier: MIT
// One thread per place of the cell order: its contacts go to the sphere that stands there.
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_unsort_counts(Params p, KernelBuffers w) {
  uint sorted_index = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (sorted_index < p.n)
    w.count[sphere_index(p, w, w.sorted[sorted_index], sorted_index)] = w.sorted_count[sorted_index];
}

Entry draw_unsort_counts_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_unsort_counts); }

}  // namespace spherepair
