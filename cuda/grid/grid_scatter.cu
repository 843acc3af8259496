// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres and puts each at the next place of its cell. The slot ahead of a cell's
// own holds that place, and so, in the end, the beginning of the cell ahead.
#include "common/shared/cell.h"
#include "cuda/kernels.cuh"

namespace spherepair {

template <bool DENSE>
__global__ void __launch_bounds__(SERVICE_BLOCK) grid_scatter(Params p, KernelBuffers w) {
  uint first = group_index(p) * SERVICE_BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  vec4 sphere[SPHERES_PER_SORTER];
  uint sorted_index[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) sphere[k] = w.position[min(first + k * SERVICE_BLOCK, p.n - 1u)];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * SERVICE_BLOCK < p.n) sorted_index[k] = atomicAdd(&w.cell[slot_of(sphere[k], DENSE, p) + 1u], 1u);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = first + k * SERVICE_BLOCK;
    if (i < p.n) {
      if ((p.indices & INDEX_IN_W) != 0u) {
        sphere[k].w = bits_float(i);
      } else {
        w.id[sorted_index[k]] = i;
      }
      w.sorted[sorted_index[k]] = sphere[k];
      w.sorted_count[i] = 0u;
    }
  }
}

Entry grid_scatter_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_scatter<true>) : reinterpret_cast<Entry>(&grid_scatter<false>);
}

}  // namespace spherepair
