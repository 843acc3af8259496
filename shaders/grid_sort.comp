#version 450
// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket too large for that is copied as it comes.
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
shared uint place[CELLS_PER_BUCKET];  // of the next sphere of each cell, in the bucket
shared uint order[SORT_ROOM / 2u];    // the spheres of the bucket by cell, two to a word

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
  uint low = group_index() * CELLS_PER_BUCKET;
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) place[c] = 0u;
  for (uint q = lane; q < SORT_ROOM / 2u; q += BLOCK) order[q] = 0u;
  barrier();
  uint turn = SORT_EACH * BLOCK;
  for (uint first = begin + lane; first < end + lane; first += turn) {
    uint c[SORT_EACH];
    for (uint k = 0u; k < SORT_EACH; ++k) c[k] = slot_of(sphere_of(min(first + k * BLOCK, end - 1u)), p) - low;
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (first + k * BLOCK < end) atomicAdd(place[c[k]], 1u);
  }
  barrier();
  uint own = 0u;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) own += place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
  uint upto = sum_up_to(own) - own;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) {
    uint counted = place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
    place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c] = upto;
    upto += counted;
  }
  barrier();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK)
    if (low + c <= p.cell_slots) cell[low + c] = begin + place[c];
  barrier();
  bool fits = end - begin <= SORT_ROOM;
  for (uint first = begin + lane; first < end + lane; first += turn) {
    uint c[SORT_EACH];
    for (uint k = 0u; k < SORT_EACH; ++k) c[k] = slot_of(sphere_of(min(first + k * BLOCK, end - 1u)), p) - low;
    for (uint k = 0u; k < SORT_EACH; ++k) {
      uint i = first + k * BLOCK;
      if (i < end) {
        uint at = atomicAdd(place[c[k]], 1u);
        if (fits) {
          atomicOr(order[at / 2u], (i - begin) << (at % 2u * 16u));
        } else {
          put(sphere_of(i), name_of(sphere_of(i), i), begin + at);
        }
      }
    }
  }
  barrier();
  for (uint first = begin + lane; fits && first < end + lane; first += turn) {
    vec4 sphere[SORT_EACH];
    uint name[SORT_EACH];
    for (uint k = 0u; k < SORT_EACH; ++k) {
      uint q = min(first + k * BLOCK, end - 1u) - begin;
      uint i = begin + (order[q / 2u] >> (q % 2u * 16u) & 0xFFFFu);
      sphere[k] = sphere_of(i);
      name[k] = name_of(sphere[k], i);
    }
    for (uint k = 0u; k < SORT_EACH; ++k)
      if (first + k * BLOCK < end) put(sphere[k], name[k], first + k * BLOCK);
  }
}
