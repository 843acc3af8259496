// SPDX-License-Identifier: MIT
// Each thread takes four spheres that stand in cell order: it writes where the cells begin that lie between a sphere's
// predecessor and it, and clears a result. A sphere out of order, or behind too many empty cells, is reported.
#include "cell.h"
#include "kernels.cuh"

namespace spherepair {

// The sphere's slot; behind the last sphere, the end of the table.
__device__ inline uint slot_at(Params p, const World& w, uint i) {
  uint slot = slot_of(w.position[min(i, p.n - 1u)], p);
  return i < p.n ? slot : p.cell_slots;
}

// The slot behind that of the sphere before this one.
__device__ inline uint slot_behind(Params p, const World& w, uint i) {
  return i == 0u ? 0u : slot_at(p, w, i - 1u) + 1u;
}

// The cells from first to last begin with sphere i.
__device__ inline void begin_cells(const World& w, uint first, uint last, uint i) {
  bool in_order = last + 1u >= first && last + 1u - first <= EMPTY_CELLS_AT_MOST;
  if (!in_order) w.tile_sum[0] = 1u;
  for (uint c = first; in_order && c <= last; ++c) w.cell[c] = i;
}

__global__ void __launch_bounds__(SERVICE_BLOCK) grid_bounds(Params p, World w) {
  uint i = group_index(p) * SERVICE_BLOCK * 4u + threadIdx.x;
  uint j = i + SERVICE_BLOCK;
  uint k = j + SERVICE_BLOCK;
  uint l = k + SERVICE_BLOCK;
  uint first_i = slot_behind(p, w, i);
  uint first_j = slot_behind(p, w, j);
  uint first_k = slot_behind(p, w, k);
  uint first_l = slot_behind(p, w, l);
  uint last_i = slot_at(p, w, i);
  uint last_j = slot_at(p, w, j);
  uint last_k = slot_at(p, w, k);
  uint last_l = slot_at(p, w, l);
  begin_cells(w, first_i, last_i, i);
  begin_cells(w, first_j, last_j, j);
  begin_cells(w, first_k, last_k, k);
  begin_cells(w, first_l, last_l, l);
  clear_results(p, w, i);
  clear_results(p, w, j);
  clear_results(p, w, k);
  clear_results(p, w, l);
}

Entry grid_bounds_kernel() { return reinterpret_cast<Entry>(&grid_bounds); }

}  // namespace spherepair
