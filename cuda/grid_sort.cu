// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket of more spheres than SORT_EACH a thread is copied as it comes.
#include "cell.h"
#include "group_sum.cuh"
#include "kernels.cuh"

namespace spherepair {

// The number of sphere i of the bucket.
__device__ inline uint name_of(const Params& p, const World& w, vec4 sphere, uint i) {
  return (p.names & NAMES_IN_RADII) != 0u ? float_bits(sphere.w) : w.from_id[i];
}
__device__ inline void put(const Params& p, const World& w, vec4 sphere, uint name, uint at) {
  if ((p.names & NAMES_IN_RADII) != 0u) sphere.w = p.radius;
  w.sorted[at] = sphere;
  w.id[at] = name;
  w.sorted_count[at] = 0u;
}

template <bool ONLY>
__global__ void __launch_bounds__(SORT_BLOCK) grid_sort(Params p, World w) {
  __shared__ uint place[CELLS_PER_BUCKET];  // of the next sphere of each cell, in the bucket; then its spheres by cell
  uint lane = threadIdx.x;
  if (group_index(p) >= p.buckets) return;
  uint begin = group_index(p) == 0u ? 0u : w.next_place[p.first_bucket + group_index(p) - 1u];
  uint end = w.next_place[p.first_bucket + group_index(p)];
  uint low = group_index(p) << p.bucket_shift;
  if (ONLY && lane == 0u)
    w.next_place[BUCKETS_AT_MOST + group_index(p)] = w.next_place[2u * BUCKETS_AT_MOST + group_index(p)] = 0u;
  for (uint c = lane; c < CELLS_PER_BUCKET; c += SORT_BLOCK) place[c] = 0u;
  __syncthreads();
  uint c[SORT_EACH];
  uint rank[SORT_EACH];  // in the cell, then in the bucket; of the spheres of the last turn
  uint turn = SORT_EACH * SORT_BLOCK;
  for (uint first = begin + lane; first < end + lane; first += turn) {
    for (uint k = 0u; k < SORT_EACH; ++k) c[k] = slot_of(w.position[min(first + k * SORT_BLOCK, end - 1u)], p) - low;
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (first + k * SORT_BLOCK < end) rank[k] = atomicAdd(&place[c[k]], 1u);
  }
  __syncthreads();
  uint own = 0u;
  for (uint k = 0u; k < CELLS_PER_BUCKET / SORT_BLOCK; ++k) own += place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k];
  uint upto = sum_up_to<SORT_BLOCK>(own) - own;
  for (uint k = 0u; k < CELLS_PER_BUCKET / SORT_BLOCK; ++k) {
    uint counted = place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k];
    place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k] = upto;
    upto += counted;
  }
  __syncthreads();
  for (uint k = lane; k < 1u << p.bucket_shift; k += SORT_BLOCK)
    if (low + k <= p.cell_slots) w.cell[low + k] = begin + place[k];
  if (end - begin <= turn) {
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (begin + lane + k * SORT_BLOCK < end) rank[k] += place[c[k]];
    __syncthreads();
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (begin + lane + k * SORT_BLOCK < end) place[rank[k]] = begin + lane + k * SORT_BLOCK;
    __syncthreads();
    for (uint at = begin + lane; at < end; at += SORT_BLOCK) {
      uint i = place[at - begin];
      vec4 sphere = w.position[i];
      put(p, w, sphere, name_of(p, w, sphere, i), at);
    }
  } else {
    __syncthreads();
    for (uint i = begin + lane; i < end; i += SORT_BLOCK) {
      vec4 sphere = w.position[i];
      put(p, w, sphere, name_of(p, w, sphere, i), begin + atomicAdd(&place[slot_of(sphere, p) - low], 1u));
    }
  }
}

Entry grid_sort_kernel(uint, Variant variant) {
  return variant.only_split ? reinterpret_cast<Entry>(&grid_sort<true>) : reinterpret_cast<Entry>(&grid_sort<false>);
}

}  // namespace spherepair
