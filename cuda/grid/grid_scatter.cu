// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER spheres: writes each to the next sorted index of its cell. The slot after a cell's
// own is the write cursor, and so, in the end, the begin of the next cell.
#include "cuda/grid/grid.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <bool DENSE>
__global__ void __launch_bounds__(BLOCK) grid_scatter(Params p, KernelBuffers buf) {
  uint first = group_index(p) * BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  vec4 sphere[SPHERES_PER_SORTER];
  uint sorted_index[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) sphere[k] = buf.position[min(first + k * BLOCK, p.n - 1u)];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * BLOCK < p.n) sorted_index[k] = atomicAdd(&buf.cell[slot_of(sphere[k], DENSE, p.grid) + 1u], 1u);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = first + k * BLOCK;
    if (i < p.n) {
      if (p.sort.index_in_w != 0u) {
        sphere[k].w = bits_float(i);
      } else {
        buf.id[sorted_index[k]] = i;
      }
      buf.sorted[sorted_index[k]] = sphere[k];
      buf.sorted_count[i] = 0u;
    }
  }
}

Entry grid_scatter_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_scatter<true>) : reinterpret_cast<Entry>(&grid_scatter<false>);
}

}  // namespace spherepair
