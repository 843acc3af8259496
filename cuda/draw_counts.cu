// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER places of the cell order: the contacts of each go to the sphere that stands there.
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_counts(Params p, World w) {
  uint first = group_index(p) * SERVICE_BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint place = first + k * SERVICE_BLOCK;
    if (place < p.n) w.count[w.id[place]] = w.sorted_count[place];
  }
}

Entry draw_counts_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_counts); }

}  // namespace spherepair
