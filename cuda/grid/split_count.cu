// SPDX-License-Identifier: MIT
// One group per SPLIT_TILE spheres: counts them by bucket. The spheres are sorted by the parents of these buckets, so
// that a tile has few buckets.
#include "cuda/grid/grid.cuh"

namespace spherepair {

constexpr uint BLOCK = SPLIT_BLOCK;

template <bool DENSE>
__global__ void __launch_bounds__(BLOCK) split_count(Params p, KernelBuffers buf) {
  __shared__ uint counted[BUCKETS_AT_MOST];
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  bool parents = p.sort.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(buf.position[end - 1u], DENSE, p.grid) : 0u, p.sort);
  vec4 sphere[SPLIT_EACH];  // all loads are issued before the first cell is computed
  for (uint k = 0u; k < SPLIT_EACH; ++k) sphere[k] = buf.position[min(first + k * BLOCK + lane, end - 1u)];
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k) bucket[k] = slot_of(sphere[k], DENSE, p.grid) >> p.sort.bucket_shift;
  uint low = parents ? bucket_below(slot_of(buf.position[first], DENSE, p.grid), p.sort) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
    for (uint b = lane; b < BUCKETS_AT_MOST; b += BLOCK) counted[b] = 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST) atomicAdd(&counted[bucket[k] - low], 1u);
    __syncthreads();
    for (uint b = lane; b < BUCKETS_AT_MOST; b += BLOCK)
      if (counted[b] != 0u) atomicAdd(&buf.bucket_cursor[p.sort.first_bucket + low + b], counted[b]);
    __syncthreads();
  }
}

Entry split_count_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&split_count<true>) : reinterpret_cast<Entry>(&split_count<false>);
}

}  // namespace spherepair
