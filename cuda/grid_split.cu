// SPDX-License-Identifier: MIT
// A group takes SORT_TILE spheres, counts them by bucket, reserves a place for all of them in each bucket, puts their
// numbers into the order of the buckets, and copies them in that order, so that neighbours are written by neighbours.
// The spheres stand in the order of the parents of these buckets, so that a tile meets few of them.
#include "cell.h"
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SPLIT_BLOCK) grid_split(Params p, World w) {
  __shared__ uint place[BUCKETS_AT_MOST];  // of the next sphere of each bucket, in the tile
  __shared__ uint shift[BUCKETS_AT_MOST];  // from there to its place among all
  __shared__ uint order[SORT_TILE];        // the spheres of the tile by bucket: bucket, number in the tile
  __shared__ uint sums[SPLIT_BLOCK];
  uint lane = threadIdx.x;
  uint first = group_index(p) * SORT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SORT_TILE, p.n);
  uint bucket[SORT_TILE / SPLIT_BLOCK];
  for (uint k = 0u; k < SORT_TILE / SPLIT_BLOCK; ++k)
    bucket[k] = slot_of(w.position[min(first + k * SPLIT_BLOCK + lane, end - 1u)], p) >> p.bucket_shift;
  uint last_bucket = bucket_above(slot_of(w.position[end - 1u], p), p);
  for (uint low = bucket_below(slot_of(w.position[first], p), p); low <= last_bucket; low += BUCKETS_AT_MOST) {
    place[lane] = 0u;
    __syncthreads();
    for (uint k = 0u; k < SORT_TILE / SPLIT_BLOCK; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        atomicAdd(&place[bucket[k] - low], 1u);
    __syncthreads();
    uint own = place[lane];
    uint upto = own;
    for (uint step = 1u; step < SPLIT_BLOCK; step *= 2u) {
      sums[lane] = upto;
      __syncthreads();
      if (lane >= step) upto += sums[lane - step];
      __syncthreads();
    }
    sums[lane] = upto;
    place[lane] = upto - own;
    if (own != 0u) shift[lane] = atomicAdd(&w.next_place[p.first_bucket + low + lane], own) - (upto - own);
    __syncthreads();
    for (uint k = 0u; k < SORT_TILE / SPLIT_BLOCK; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        order[atomicAdd(&place[bucket[k] - low], 1u)] = (bucket[k] - low) * SORT_TILE + k * SPLIT_BLOCK + lane;
    __syncthreads();
    for (uint q = lane; q < sums[SPLIT_BLOCK - 1u]; q += SPLIT_BLOCK) {
      uint i = first + order[q] % SORT_TILE;
      uint at = q + shift[order[q] / SORT_TILE];
      w.sorted[at] = w.position[i];
      w.id[at] = p.named == 0u ? i : w.from_id[i];
    }
    __syncthreads();
  }
}

Entry grid_split_kernel() { return reinterpret_cast<Entry>(&grid_split); }

}  // namespace spherepair
