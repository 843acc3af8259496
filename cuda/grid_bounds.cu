// SPDX-License-Identifier: MIT
// Each thread takes four consecutive spheres that stand in cell order: it writes where the cells begin that lie between
// a sphere's predecessor and it, and clears four results. A sphere out of order, or behind too many empty cells, is
// reported.
#include "cell.h"
#include "kernels.cuh"

namespace spherepair {

// The sphere's slot; behind the last sphere, the end of the table.
__device__ inline uint slot_at(Params p, const World& w, uint i) {
  uint slot = slot_of(w.position[min(i, p.n - 1u)], p);
  return i < p.n ? slot : p.cell_slots;
}

// The cells from first to last begin with sphere i.
__device__ inline void begin_cells(const World& w, uint first, uint last, uint i) {
  bool in_order = last + 1u >= first && last + 1u - first <= EMPTY_CELLS_AT_MOST;
  if (!in_order) w.scan[0] = 1u;
  for (uint c = first; in_order && c <= last; ++c) w.cell[c] = i;
}

__global__ void __launch_bounds__(SERVICE_BLOCK) grid_bounds(Params p, World w) {
  uint start = group_index(p) * SERVICE_BLOCK * 4u + threadIdx.x;
  for (uint k = 0u; k < 4u; ++k) clear_results(p, w, start + k * SERVICE_BLOCK);
  uint i = (group_index(p) * SERVICE_BLOCK + threadIdx.x) * 4u;
  uint before = i == 0u ? 0u : slot_at(p, w, i - 1u) + 1u;
  uint a = slot_at(p, w, i);
  uint b = slot_at(p, w, i + 1u);
  uint c = slot_at(p, w, i + 2u);
  uint d = slot_at(p, w, i + 3u);
  begin_cells(w, before, a, i);
  begin_cells(w, a + 1u, b, i + 1u);
  begin_cells(w, b + 1u, c, i + 2u);
  begin_cells(w, c + 1u, d, i + 3u);
}

Entry grid_bounds_kernel() { return reinterpret_cast<Entry>(&grid_bounds); }

}  // namespace spherepair
