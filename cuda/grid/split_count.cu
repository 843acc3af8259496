// SPDX-License-Identifier: MIT
// A group takes SPLIT_TILE spheres and counts how many go into each bucket. The spheres stand in the order of the
// parents of these buckets, so that a tile meets few of them.
#include "common/shared/cell.h"
#include "cuda/kernels.cuh"

namespace spherepair {

template <bool DENSE>
__global__ void __launch_bounds__(SPLIT_BLOCK) split_count(Params p, KernelBuffers w) {
  __shared__ uint counted[BUCKETS_AT_MOST];
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  bool parents = p.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(w.position[end - 1u], DENSE, p) : 0u, p);
  vec4 sphere[SPLIT_EACH];  // all on their way before the first is asked for its cell
  for (uint k = 0u; k < SPLIT_EACH; ++k) sphere[k] = w.position[min(first + k * SPLIT_BLOCK + lane, end - 1u)];
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k) bucket[k] = slot_of(sphere[k], DENSE, p) >> p.bucket_shift;
  uint low = parents ? bucket_below(slot_of(w.position[first], DENSE, p), p) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
    for (uint b = lane; b < BUCKETS_AT_MOST; b += SPLIT_BLOCK) counted[b] = 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        atomicAdd(&counted[bucket[k] - low], 1u);
    __syncthreads();
    for (uint b = lane; b < BUCKETS_AT_MOST; b += SPLIT_BLOCK)
      if (counted[b] != 0u) atomicAdd(&w.bucket_cursor[p.first_bucket + low + b], counted[b]);
    __syncthreads();
  }
}

Entry split_count_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&split_count<true>) : reinterpret_cast<Entry>(&split_count<false>);
}

}  // namespace spherepair
