// SPDX-License-Identifier: MIT
// A group takes SPLIT_TILE spheres, counts them by bucket, reserves a place for all of them in each bucket, puts their
// numbers into the order of the buckets, and copies them in that order, so that neighbours are written by neighbours.
// The spheres stand in the order of the parents of these buckets, so that a tile meets few of them. Where there is one
// split only, each group makes of the counts the places where the buckets begin, a bucket a thread.
#include "cell.h"
#include "group_sum.cuh"
#include "kernels.cuh"

namespace spherepair {

// Of SLOT_BUCKET, where there is one split only: where each bucket ends, how many spheres it has, how many have a
// place; BUCKETS_AT_MOST words each, of which grid_sort leaves the latter two at 0.
template <bool ONLY>
__global__ void __launch_bounds__(SPLIT_BLOCK, 2) grid_split(Params p, World w) {
  __shared__ uint place[BUCKETS_AT_MOST];  // of the next sphere of each bucket; then from there to its place among all
  __shared__ uint order[SPLIT_TILE];       // the spheres of the tile by bucket: bucket, number in the tile
  __shared__ uint taken;                   // spheres of this turn
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  uint spheres = ONLY ? w.next_place[BUCKETS_AT_MOST + lane] : 0u;
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(w.position[min(first + k * SPLIT_BLOCK + lane, end - 1u)], p) >> p.bucket_shift;
  uint begin = 0u;
  if constexpr (ONLY) {
    uint bucket_end = sum_up_to<SPLIT_BLOCK>(spheres);
    begin = bucket_end - spheres;
    if (first == 0u) w.next_place[lane] = bucket_end;
  }
  uint places = ONLY ? 2u * BUCKETS_AT_MOST : p.first_bucket;  // where those begin that are handed out
  bool parents = p.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(w.position[end - 1u], p) : 0u, p);
  uint low = parents ? bucket_below(slot_of(w.position[first], p), p) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
    place[lane] = 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        atomicAdd(&place[bucket[k] - low], 1u);
    __syncthreads();
    uint own = place[lane];
    uint upto = sum_up_to<SPLIT_BLOCK>(own);
    if (lane == SPLIT_BLOCK - 1u) taken = upto;
    place[lane] = upto - own;
    uint shift = own != 0u ? begin + atomicAdd(&w.next_place[places + low + lane], own) - (upto - own) : 0u;
    __syncthreads();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * SPLIT_BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        order[atomicAdd(&place[bucket[k] - low], 1u)] = (bucket[k] - low) * SPLIT_TILE + k * SPLIT_BLOCK + lane;
    __syncthreads();
    place[lane] = shift;
    __syncthreads();
    for (uint q = lane; q < taken; q += SPLIT_BLOCK) {
      uint i = first + order[q] % SPLIT_TILE;
      uint at = q + place[order[q] / SPLIT_TILE];
      vec4 sphere = w.position[i];
      bool in_radii = (p.names & NAMES_IN_RADII) != 0u;
      uint name = (p.names & NAMES_GIVEN) == 0u ? i : in_radii ? float_bits(sphere.w) : w.from_id[i];
      if (in_radii) sphere.w = bits_float(name);
      if (!in_radii) w.id[at] = name;
      w.sorted[at] = sphere;
    }
    __syncthreads();
  }
}

Entry grid_split_kernel(uint, Variant variant) {
  return variant.only_split ? reinterpret_cast<Entry>(&grid_split<true>) : reinterpret_cast<Entry>(&grid_split<false>);
}

}  // namespace spherepair
