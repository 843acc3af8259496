// SPDX-License-Identifier: MIT
// One group per SPLIT_TILE spheres: counts them by bucket, reserves a range of each bucket, sorts their indices by
// bucket in shared memory, and copies the spheres in that order, so that writes are coalesced. The spheres are sorted
// by the parents of these buckets, so that a tile has few buckets.
#include "cuda/grid/grid.cuh"
#include "cuda/grid/group_sum.cuh"

namespace spherepair {

constexpr uint BLOCK = SPLIT_BLOCK;

template <bool DENSE>
__global__ void __launch_bounds__(BLOCK, 2) grid_split(Params p, KernelBuffers buf) {
  __shared__ uint
      cursor[BUCKETS_AT_MOST];        // of each bucket in `order`; then the offset from there to the bucket's range
  __shared__ uint order[SPLIT_TILE];  // the spheres of the tile by bucket: bucket, index in the tile
  __shared__ uint taken;              // spheres of this pass
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(buf.position[min(first + k * BLOCK + lane, end - 1u)], DENSE, p.grid) >> p.sort.bucket_shift;
  bool parents = p.sort.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(buf.position[end - 1u], DENSE, p.grid) : 0u, p.sort);
  uint low = parents ? bucket_below(slot_of(buf.position[first], DENSE, p.grid), p.sort) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
    cursor[lane] = 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST) atomicAdd(&cursor[bucket[k] - low], 1u);
    __syncthreads();
    uint own = cursor[lane];
    uint upto = sum_up_to<BLOCK>(own);
    if (lane == BLOCK - 1u) taken = upto;
    cursor[lane] = upto - own;
    uint shift = own != 0u ? atomicAdd(&buf.bucket_cursor[p.sort.first_bucket + low + lane], own) - (upto - own) : 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        order[atomicAdd(&cursor[bucket[k] - low], 1u)] = (bucket[k] - low) * SPLIT_TILE + k * BLOCK + lane;
    __syncthreads();
    cursor[lane] = shift;
    __syncthreads();
    for (uint q = lane; q < taken; q += BLOCK) {
      uint i = first + order[q] % SPLIT_TILE;
      uint at = q + cursor[order[q] / SPLIT_TILE];
      vec4 sphere = buf.position[i];
      bool in_w = p.sort.index_in_w != 0u;
      uint index = p.sort.index_given == 0u ? i : in_w ? float_bits(sphere.w) : buf.from_id[i];
      if (in_w) sphere.w = bits_float(index);
      if (!in_w) buf.id[at] = index;
      buf.sorted[at] = sphere;
    }
    __syncthreads();
  }
}

Entry grid_split_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_split<true>) : reinterpret_cast<Entry>(&grid_split<false>);
}

}  // namespace spherepair
