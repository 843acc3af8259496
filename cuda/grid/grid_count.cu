// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres and counts each in its cell, one slot ahead of the cell's own, and in
// the cell's tile of the scan.
#include "common/shared/cell.h"
#include "cuda/kernels.cuh"

namespace spherepair {

template <bool DENSE>
__global__ void __launch_bounds__(SERVICE_BLOCK) grid_count(Params p, KernelBuffers w) {
  uint first = group_index(p) * SERVICE_BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  uint slot[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    slot[k] = slot_of(w.position[min(first + k * SERVICE_BLOCK, p.n - 1u)], DENSE, p);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * SERVICE_BLOCK < p.n) atomicAdd(&w.cell[slot[k] + 1u], 1u);
}

Entry grid_count_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_count<true>) : reinterpret_cast<Entry>(&grid_count<false>);
}

}  // namespace spherepair
