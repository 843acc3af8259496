#version 450
// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket too large for that is copied as it comes.
#define CELL_ACCESS
#define ID_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_SPLIT_ID) restrict readonly buffer FromIdBuffer { uint from_id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict writeonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint next_place[]; };
layout(local_size_x = BLOCK) in;
shared uint place[CELLS_PER_BUCKET];  // of the next sphere of each cell, in the bucket
shared uint order[SORT_TILE];         // the spheres of the bucket by cell
shared uint sums[BLOCK];

void put(uint i, uint at) {
  sorted[at] = position[i];
  id[at] = from_id[i];
  sorted_count[at] = 0u;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (group_index() >= p.buckets) return;
  uint begin = group_index() == 0u ? 0u : next_place[p.first_bucket + group_index() - 1u];
  uint end = next_place[p.first_bucket + group_index()];
  uint low = group_index() * CELLS_PER_BUCKET;
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) place[c] = 0u;
  barrier();
  for (uint i = begin + lane; i < end; i += BLOCK) atomicAdd(place[slot_of(position[i], p) - low], 1u);
  barrier();
  uint own = 0u;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) own += place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
  uint upto = own;
  for (uint step = 1u; step < BLOCK; step *= 2u) {
    sums[lane] = upto;
    barrier();
    if (lane >= step) upto += sums[lane - step];
    barrier();
  }
  upto -= own;
  for (uint c = 0u; c < CELLS_PER_BUCKET / SORT_BLOCK; ++c) {
    uint counted = place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c];
    place[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + c] = upto;
    upto += counted;
  }
  barrier();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK)
    if (low + c <= p.cell_slots) cell[low + c] = begin + place[c];
  barrier();
  bool fits = end - begin <= SORT_TILE;
  for (uint i = begin + lane; i < end; i += BLOCK) {
    uint at = atomicAdd(place[slot_of(position[i], p) - low], 1u);
    if (fits) {
      order[at] = i;
    } else {
      put(i, begin + at);
    }
  }
  barrier();
  for (uint q = lane; fits && q < end - begin; q += BLOCK) put(order[q], begin + q);
}
