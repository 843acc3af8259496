// SPDX-License-Identifier: MIT
// A group takes SPLIT_TILE spheres, counts them by bucket, reserves a place for all of them in each bucket, puts their
// numbers into the order of the buckets, and copies them in that order, so that neighbours are written by neighbours.
// The spheres stand in the order of the parents of these buckets, so that a tile meets few of them.
#include "common/shared/cell.h"
#include "cuda/grid/group_sum.cuh"
#include "cuda/kernels.cuh"

namespace spherepair {

template <bool DENSE>
__global__ void __launch_bounds__(SPLIT_BLOCK, 2) grid_split(Params p, KernelBuffers w) {
  __shared__ uint
      sorted_index[BUCKETS_AT_MOST];  // of the next sphere of each bucket; then from there to its place among all
  __shared__ uint order[SPLIT_TILE];  // the spheres of the tile by bucket: bucket, number in the tile
  __shared__ uint taken;              // spheres of this turn
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(w.position[min(first + k * SPLIT_BLOCK + lane, end - 1u)], DENSE, p) >> p.bucket_shift;
  bool parents = p.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(w.position[end - 1u], DENSE, p) : 0u, p);
  uint low = parents ? bucket_below(slot_of(w.position[first], DENSE, p), p) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
    sorted_index[lane] = 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        atomicAdd(&sorted_index[bucket[k] - low], 1u);
    __syncthreads();
    uint own = sorted_index[lane];
    uint upto = sum_up_to<SPLIT_BLOCK>(own);
    if (lane == SPLIT_BLOCK - 1u) taken = upto;
    sorted_index[lane] = upto - own;
    uint shift = own != 0u ? atomicAdd(&w.bucket_cursor[p.first_bucket + low + lane], own) - (upto - own) : 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        order[atomicAdd(&sorted_index[bucket[k] - low], 1u)] = (bucket[k] - low) * SPLIT_TILE + k * SPLIT_BLOCK + lane;
    __syncthreads();
    sorted_index[lane] = shift;
    __syncthreads();
    for (uint q = lane; q < taken; q += SPLIT_BLOCK) {
      uint i = first + order[q] % SPLIT_TILE;
      uint at = q + sorted_index[order[q] / SPLIT_TILE];
      vec4 sphere = w.position[i];
      bool in_radii = (p.indices & INDEX_IN_W) != 0u;
      uint name = (p.indices & INDEX_GIVEN) == 0u ? i : in_radii ? float_bits(sphere.w) : w.from_id[i];
      if (in_radii) sphere.w = bits_float(name);
      if (!in_radii) w.id[at] = name;
      w.sorted[at] = sphere;
    }
    __syncthreads();
  }
}

Entry grid_split_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&grid_split<true>) : reinterpret_cast<Entry>(&grid_split<false>);
}

}  // namespace spherepair
