// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres that stand in cell order: it writes where the cells begin that lie
// between the sphere's predecessor and it, and clears the results. A sphere out of order, or behind too many empty
// cells, is reported.
#include "cell.h"
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) grid_bounds(Params p, World w) {
  uint start = group_index(p) * SERVICE_BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  uint first[SPHERES_PER_SORTER];
  uint last[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = min(start + k * SERVICE_BLOCK, p.n);
    first[k] = i == 0u ? 0u : slot_of(w.position[i - 1u], p) + 1u;
    last[k] = i == p.n ? p.cell_slots : slot_of(w.position[i], p);
  }
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = start + k * SERVICE_BLOCK;
    clear_results(p, w, i);
    bool in_order = i <= p.n && last[k] + 1u >= first[k] && last[k] + 1u - first[k] <= EMPTY_CELLS_AT_MOST;
    if (i <= p.n && !in_order) w.scan[0] = 1u;
    for (uint c = first[k]; in_order && c <= last[k]; ++c) w.cell[c] = i;
  }
}

Entry grid_bounds_kernel() { return reinterpret_cast<Entry>(&grid_bounds); }

}  // namespace spherepair
