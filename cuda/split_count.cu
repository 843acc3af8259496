// SPDX-License-Identifier: MIT
// A group takes SPLIT_TILE spheres and counts how many go into each bucket. The spheres stand in the order of the
// parents of these buckets, so that a tile meets few of them.
#include "cell.h"
#include "kernels.cuh"

namespace spherepair {

// ONLY: there is one split only, as grid_split has it; results are cleared here then.
template <bool ONLY>
__global__ void __launch_bounds__(SPLIT_BLOCK) split_count(Params p, World w) {
  __shared__ uint counted[BUCKETS_AT_MOST];
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  for (uint k = lane; ONLY && first == 0u && k < SUMMARY_SLOTS * SUMMARY_WORDS; k += SPLIT_BLOCK) w.summary[k] = 0u;
  uint counts = ONLY ? BUCKETS_AT_MOST : p.first_bucket;
  bool parents = p.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(w.position[end - 1u], p) : 0u, p);
  vec4 sphere[SPLIT_EACH];  // all on their way before the first is asked for its cell
  for (uint k = 0u; k < SPLIT_EACH; ++k) sphere[k] = w.position[min(first + k * SPLIT_BLOCK + lane, end - 1u)];
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k) bucket[k] = slot_of(sphere[k], p) >> p.bucket_shift;
  uint low = parents ? bucket_below(slot_of(w.position[first], p), p) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
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
}

Entry split_count_kernel(uint, Variant variant) {
  return variant.only_split ? reinterpret_cast<Entry>(&split_count<true>)
                            : reinterpret_cast<Entry>(&split_count<false>);
}

}  // namespace spherepair
