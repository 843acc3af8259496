// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket too large for that is copied as it comes.
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

__global__ void __launch_bounds__(SORT_BLOCK) grid_sort(Params p, World w) {
  __shared__ uint place[CELLS_PER_BUCKET];  // of the next sphere of each cell, in the bucket
  __shared__ uint order[SORT_ROOM / 2u];    // the spheres of the bucket by cell, two to a word
  uint lane = threadIdx.x;
  if (group_index(p) >= p.buckets) return;
  uint begin = group_index(p) == 0u ? 0u : w.next_place[p.first_bucket + group_index(p) - 1u];
  uint end = w.next_place[p.first_bucket + group_index(p)];
  uint low = group_index(p) * CELLS_PER_BUCKET;
  for (uint c = lane; c < CELLS_PER_BUCKET; c += SORT_BLOCK) place[c] = 0u;
  for (uint q = lane; q < SORT_ROOM / 2u; q += SORT_BLOCK) order[q] = 0u;
  __syncthreads();
  uint turn = SORT_EACH * SORT_BLOCK;
  for (uint first = begin + lane; first < end + lane; first += turn) {
    uint c[SORT_EACH];
    for (uint k = 0u; k < SORT_EACH; ++k) c[k] = slot_of(w.position[min(first + k * SORT_BLOCK, end - 1u)], p) - low;
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (first + k * SORT_BLOCK < end) atomicAdd(&place[c[k]], 1u);
  }
  __syncthreads();
  uint own = 0u;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) own += place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
  uint upto = sum_up_to<SORT_BLOCK>(own) - own;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) {
    uint counted = place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
    place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c] = upto;
    upto += counted;
  }
  __syncthreads();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += SORT_BLOCK)
    if (low + c <= p.cell_slots) w.cell[low + c] = begin + place[c];
  __syncthreads();
  bool fits = end - begin <= SORT_ROOM;
  for (uint first = begin + lane; first < end + lane; first += turn) {
    uint c[SORT_EACH];
    for (uint k = 0u; k < SORT_EACH; ++k) c[k] = slot_of(w.position[min(first + k * SORT_BLOCK, end - 1u)], p) - low;
    for (uint k = 0u; k < SORT_EACH; ++k) {
      uint i = first + k * SORT_BLOCK;
      if (i < end) {
        uint at = atomicAdd(&place[c[k]], 1u);
        if (fits) {
          atomicOr(&order[at / 2u], (i - begin) << (at % 2u * 16u));
        } else {
          put(p, w, w.position[i], name_of(p, w, w.position[i], i), begin + at);
        }
      }
    }
  }
  __syncthreads();
  for (uint first = begin + lane; fits && first < end + lane; first += turn) {
    vec4 sphere[SORT_EACH];
    uint name[SORT_EACH];
    for (uint k = 0u; k < SORT_EACH; ++k) {
      uint q = min(first + k * SORT_BLOCK, end - 1u) - begin;
      uint i = begin + (order[q / 2u] >> (q % 2u * 16u) & 0xFFFFu);
      sphere[k] = w.position[i];
      name[k] = name_of(p, w, sphere[k], i);
    }
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (first + k * SORT_BLOCK < end) put(p, w, sphere[k], name[k], first + k * SORT_BLOCK);
  }
}

Entry grid_sort_kernel(uint, Variant) { return reinterpret_cast<Entry>(&grid_sort); }

}  // namespace spherepair
