// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres: it counts each in its cell, and the count so far is the sphere's rank.
#include "cell.h"
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) grid_count(Params p, World w) {
  uint first = group_index(p) * SERVICE_BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  uint slot[SPHERES_PER_SORTER];
  uint before[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    slot[k] = slot_of(w.position[min(first + k * SERVICE_BLOCK, p.n - 1u)], p);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * SERVICE_BLOCK < p.n) before[k] = atomicAdd(&w.cell[slot[k]], 1u);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * SERVICE_BLOCK < p.n) w.rank[first + k * SERVICE_BLOCK] = before[k];
}

Entry grid_count_kernel() { return reinterpret_cast<Entry>(&grid_count); }

}  // namespace spherepair
