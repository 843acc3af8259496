// SPDX-License-Identifier: MIT
// A group takes SPLIT_TILE spheres and counts how many go into each bucket. The spheres stand in the order of the
// parents of these buckets, so that a tile meets few of them. Where there is one split only, the group that is done
// last makes of the counts the places where the buckets begin, a bucket a thread, and clears counts and results.
#include "cell.h"
#include "group_sum.cuh"
#include "kernels.cuh"

namespace spherepair {

// Of SLOT_BUCKET: BUCKETS_AT_MOST places, as many counts, and how many groups have counted.
__device__ inline void finish_split(const World& w, uint groups) {
  __shared__ uint groups_before;
  uint lane = threadIdx.x;
  __threadfence();
  __syncthreads();
  if (lane == 0u) groups_before = atomicAdd(&w.next_place[2u * BUCKETS_AT_MOST], 1u);
  __syncthreads();
  if (groups_before + 1u != groups) return;
  __threadfence();
  uint own = atomicExch(&w.next_place[BUCKETS_AT_MOST + lane], 0u);
  w.next_place[lane] = sum_up_to<SPLIT_BLOCK>(own) - own;
  if (lane == 0u) w.next_place[2u * BUCKETS_AT_MOST] = 0u;
  for (uint k = lane; k < SUMMARY_SLOTS * SUMMARY_WORDS; k += SPLIT_BLOCK) w.summary[k] = 0u;
}

template <bool ONLY>
__global__ void __launch_bounds__(SPLIT_BLOCK) split_count(Params p, World w) {
  __shared__ uint counted[BUCKETS_AT_MOST];
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  uint counts = ONLY ? BUCKETS_AT_MOST : p.first_bucket;
  uint last_bucket = bucket_above(slot_of(w.position[end - 1u], p), p);
  vec4 sphere[SPLIT_EACH];  // all on their way before the first is asked for its cell
  for (uint k = 0u; k < SPLIT_EACH; ++k) sphere[k] = w.position[min(first + k * SPLIT_BLOCK + lane, end - 1u)];
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k) bucket[k] = slot_of(sphere[k], p) >> p.bucket_shift;
  for (uint low = bucket_below(slot_of(w.position[first], p), p); low <= last_bucket; low += BUCKETS_AT_MOST) {
    for (uint b = lane; b < BUCKETS_AT_MOST; b += SPLIT_BLOCK) counted[b] = 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        atomicAdd(&counted[bucket[k] - low], 1u);
    __syncthreads();
    for (uint b = lane; b < BUCKETS_AT_MOST; b += SPLIT_BLOCK)
      if (counted[b] != 0u) atomicAdd(&w.next_place[counts + low + b], counted[b]);
    __syncthreads();
  }
  if (ONLY) finish_split(w, (p.n + SPLIT_TILE - 1u) / SPLIT_TILE);
}

Entry split_count_kernel(uint, Variant variant) {
  return variant.only_split ? reinterpret_cast<Entry>(&split_count<true>)
                            : reinterpret_cast<Entry>(&split_count<false>);
}

}  // namespace spherepair
