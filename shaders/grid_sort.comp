#version 450
// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket of more spheres than SORT_EACH a thread is copied as it comes.
#define CELL_ACCESS
#define ID_ACCESS
#define SORTS_SPHERES
#include "grid.glsl"
#include "group_sum.glsl"

layout(std430, binding = SLOT_SPLIT_ID) restrict readonly buffer FromIdBuffer { uint from_id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict writeonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint next_place[]; };
layout(local_size_x = BLOCK) in;
shared uint place[CELLS_PER_BUCKET];  // of the next sphere of each cell, in the bucket; then its spheres by cell

// The number of sphere i of the bucket.
uint name_of(vec4 sphere, uint i) { return (p.names & NAMES_IN_RADII) != 0u ? float_bits(sphere.w) : from_id[i]; }
void put(vec4 sphere, uint name, uint at) {
  if ((p.names & NAMES_IN_RADII) != 0u) sphere.w = p.radius;
  sorted[at] = sphere;
  id[at] = name;
  sorted_count[at] = 0u;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (group_index() >= p.buckets) return;
  uint begin = group_index() == 0u ? 0u : next_place[p.first_bucket + group_index() - 1u];
  uint end = next_place[p.first_bucket + group_index()];
  uint low = group_index() << p.bucket_shift;
#ifdef ONLY_SPLIT
  if (lane == 0u) next_place[BUCKETS_AT_MOST + group_index()] = next_place[2u * BUCKETS_AT_MOST + group_index()] = 0u;
#endif
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) place[c] = 0u;
  barrier();
  uint c[SORT_EACH];
  uint rank[SORT_EACH];  // in the cell, then in the bucket; of the spheres of the last turn
  uint turn = SORT_EACH * BLOCK;
  for (uint first = begin + lane; first < end + lane; first += turn) {
    for (uint k = 0u; k < SORT_EACH; ++k) c[k] = slot_of(sphere_of(min(first + k * BLOCK, end - 1u)), p) - low;
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (first + k * BLOCK < end) rank[k] = atomicAdd(place[c[k]], 1u);
  }
  barrier();
  uint own = 0u;
  for (uint k = 0u; k < CELLS_PER_BUCKET / SORT_BLOCK; ++k) own += place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k];
  uint upto = sum_up_to(own) - own;
  for (uint k = 0u; k < CELLS_PER_BUCKET / SORT_BLOCK; ++k) {
    uint counted = place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k];
    place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k] = upto;
    upto += counted;
  }
  barrier();
  for (uint k = lane; k < 1u << p.bucket_shift; k += BLOCK)
    if (low + k <= p.cell_slots) cell[low + k] = begin + place[k];
  if (end - begin <= turn) {
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (begin + lane + k * BLOCK < end) rank[k] += place[c[k]];
    barrier();
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (begin + lane + k * BLOCK < end) place[rank[k]] = begin + lane + k * BLOCK;
    barrier();
    for (uint at = begin + lane; at < end; at += BLOCK) {
      uint i = place[at - begin];
      vec4 sphere = sphere_of(i);
      put(sphere, name_of(sphere, i), at);
    }
  } else {
    barrier();
    for (uint i = begin + lane; i < end; i += BLOCK) {
      vec4 sphere = sphere_of(i);
      put(sphere, name_of(sphere, i), begin + atomicAdd(place[slot_of(sphere, p) - low], 1u));
    }
  }
}
