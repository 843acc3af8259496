// SPDX-License-Identifier: MIT
// One thread per place of the cell order: its contacts go to the sphere that stands there.
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_counts(Params p, World w) {
  uint place = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (place < p.n) w.count[number_of(p, w, w.sorted[place], place)] = w.sorted_count[place];
}

Entry draw_counts_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_counts); }

}  // namespace spherepair
