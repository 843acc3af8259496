// SPDX-License-Identifier: MIT
// One group per BOUNDS_TILE spheres that are in cell order: it writes where the cells between each sphere and its
// predecessor begin, through shared memory, so that writes are coalesced, and clears the spheres' results. A sphere
// that is out of order, or follows too many empty cells, is reported.
#include "cuda/grid/grid.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

// Returns the sphere's slot; past the last sphere, the end of the table.
template <bool DENSE>
__device__ inline uint slot_at(const Params& p, const KernelBuffers& buf, uint i) {
  uint own = slot_of(buf.position[min(i, p.n - 1u)], DENSE, p.grid);
  return i < p.n ? own : p.grid.cell_slots;
}

template <bool DENSE>
__global__ void __launch_bounds__(BLOCK) grid_bounds(Params p, KernelBuffers buf) {
  __shared__ uint slot[BOUNDS_TILE + 1u];  // of the sphere before the first one, then of each
  __shared__ uint begins[BOUNDS_WINDOW];   // the window of the table that is being filled
  __shared__ uint disorder;
  uint lane = threadIdx.x;
  uint first = group_index(p) * BOUNDS_TILE;
  if (lane == 0u) disorder = 0u;
  if (lane == 0u) slot[0] = first == 0u ? ~0u : slot_at<DENSE>(p, buf, first - 1u);
  for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) slot[k + 1u] = slot_at<DENSE>(p, buf, first + k);
  for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) clear_results(p, buf, first + k);
  __syncthreads();
  for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) {
    bool in_order = slot[k] + 1u <= slot[k + 1u] + 1u && slot[k + 1u] - slot[k] <= EMPTY_CELLS_AT_MOST;
    if (!in_order) disorder = 1u;
  }
  __syncthreads();
  if (disorder != 0u) {
    if (lane == 0u) buf.tile_sum[0] = 1u;
    return;
  }
  uint behind = slot[BOUNDS_TILE] + 1u;
  for (uint low = slot[0] + 1u; low < behind; low += BOUNDS_WINDOW) {
    uint high = min(low + BOUNDS_WINDOW, behind);
    for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) {
      uint end = min(slot[k + 1u] + 1u, high);
      for (uint c = max(slot[k] + 1u, low); c < end; ++c) begins[c - low] = first + k;
    }
    __syncthreads();
    for (uint c = low + lane; c < high; c += BLOCK) buf.cell[c] = begins[c - low];
    __syncthreads();
  }
}

Entry grid_bounds_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_bounds<true>) : reinterpret_cast<Entry>(&grid_bounds<false>);
}

}  // namespace spherepair
