// SPDX-License-Identifier: MIT
// A group takes spheres that stand in cell order and writes where the cells begin that lie between each of them and its
// predecessor, through shared memory, so that neighbours are written by neighbours; and clears their results. A sphere
// out of order, or behind too many empty cells, is reported.
#include "common/shared/cell.h"
#include "cuda/kernels.cuh"

namespace spherepair {

// The sphere's slot; behind the last sphere, the end of the table.
template <bool DENSE>
__device__ inline uint slot_at(Params p, const KernelBuffers& w, uint i) {
  uint own = slot_of(w.position[min(i, p.n - 1u)], DENSE, p);
  return i < p.n ? own : p.cell_slots;
}

template <bool DENSE>
__global__ void __launch_bounds__(SERVICE_BLOCK) grid_bounds(Params p, KernelBuffers w) {
  __shared__ uint slot[BOUNDS_TILE + 1];  // of the sphere before the first one, then of each
  __shared__ uint begins[BOUNDS_WINDOW];  // the part of the table that is being filled in
  __shared__ uint disorder;
  uint lane = threadIdx.x;
  uint first = group_index(p) * BOUNDS_TILE;
  if (lane == 0u) disorder = 0u;
  if (lane == 0u) slot[0] = first == 0u ? ~0u : slot_at<DENSE>(p, w, first - 1u);
  for (uint k = lane; k < BOUNDS_TILE; k += SERVICE_BLOCK) slot[k + 1u] = slot_at<DENSE>(p, w, first + k);
  for (uint k = lane; k < BOUNDS_TILE; k += SERVICE_BLOCK) clear_results(p, w, first + k);
  __syncthreads();
  for (uint k = lane; k < BOUNDS_TILE; k += SERVICE_BLOCK) {
    bool in_order = slot[k] + 1u <= slot[k + 1u] + 1u && slot[k + 1u] - slot[k] <= EMPTY_CELLS_AT_MOST;
    if (!in_order) disorder = 1u;
  }
  __syncthreads();
  if (disorder != 0u) {
    if (lane == 0u) w.tile_sum[0] = 1u;
    return;
  }
  uint behind = slot[BOUNDS_TILE] + 1u;
  for (uint low = slot[0] + 1u; low < behind; low += BOUNDS_WINDOW) {
    uint high = min(low + BOUNDS_WINDOW, behind);
    for (uint k = lane; k < BOUNDS_TILE; k += SERVICE_BLOCK) {
      uint end = min(slot[k + 1u] + 1u, high);
      for (uint c = max(slot[k] + 1u, low); c < end; ++c) begins[c - low] = first + k;
    }
    __syncthreads();
    for (uint c = low + lane; c < high; c += SERVICE_BLOCK) w.cell[c] = begins[c - low];
    __syncthreads();
  }
}

Entry grid_bounds_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_bounds<true>) : reinterpret_cast<Entry>(&grid_bounds<false>);
}

}  // namespace spherepair
