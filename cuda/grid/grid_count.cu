// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER spheres: counts each in its cell, one slot after the cell's own.
#include "cuda/grid/grid.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <bool DENSE>
__global__ void __launch_bounds__(BLOCK) grid_count(Params p, KernelBuffers buf) {
  uint first = group_index(p) * BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  uint slot[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    slot[k] = slot_of(buf.position[min(first + k * BLOCK, p.n - 1u)], DENSE, p.grid);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * BLOCK < p.n) atomicAdd(&buf.cell[slot[k] + 1u], 1u);
}

Entry grid_count_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_count<true>) : reinterpret_cast<Entry>(&grid_count<false>);
}

}  // namespace spherepair
