// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket too large for that is copied as it comes.
#include "cell.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline void put(const World& w, uint i, uint at) {
  w.sorted[at] = w.position[i];
  w.id[at] = w.from_id[i];
  w.sorted_count[at] = 0u;
}

__global__ void __launch_bounds__(SORT_BLOCK) grid_sort(Params p, World w) {
  __shared__ uint place[CELLS_PER_BUCKET];  // of the next sphere of each cell, in the bucket
  __shared__ uint order[SORT_TILE];         // the spheres of the bucket by cell
  __shared__ uint sums[SORT_BLOCK];
  uint lane = threadIdx.x;
  if (group_index(p) >= p.buckets) return;
  uint begin = group_index(p) == 0u ? 0u : w.next_place[p.first_bucket + group_index(p) - 1u];
  uint end = w.next_place[p.first_bucket + group_index(p)];
  uint low = group_index(p) * CELLS_PER_BUCKET;
  for (uint c = lane; c < CELLS_PER_BUCKET; c += SORT_BLOCK) place[c] = 0u;
  __syncthreads();
  for (uint i = begin + lane; i < end; i += SORT_BLOCK) atomicAdd(&place[slot_of(w.position[i], p) - low], 1u);
  __syncthreads();
  uint own = 0u;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) own += place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
  uint upto = own;
  for (uint step = 1u; step < SORT_BLOCK; step *= 2u) {
    sums[lane] = upto;
    __syncthreads();
    if (lane >= step) upto += sums[lane - step];
    __syncthreads();
  }
  upto -= own;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) {
    uint counted = place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
    place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c] = upto;
    upto += counted;
  }
  __syncthreads();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += SORT_BLOCK)
    if (low + c <= p.cell_slots) w.cell[low + c] = begin + place[c];
  __syncthreads();
  bool fits = end - begin <= SORT_TILE;
  for (uint i = begin + lane; i < end; i += SORT_BLOCK) {
    uint at = atomicAdd(&place[slot_of(w.position[i], p) - low], 1u);
    if (fits) {
      order[at] = i;
    } else {
      put(w, i, begin + at);
    }
  }
  __syncthreads();
  for (uint q = lane; fits && q < end - begin; q += SORT_BLOCK) put(w, order[q], begin + q);
}

Entry grid_sort_kernel() { return reinterpret_cast<Entry>(&grid_sort); }

}  // namespace spherepair
