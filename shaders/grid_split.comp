#version 450
// SPDX-License-Identifier: MIT
// A group takes SORT_TILE spheres, counts them by bucket, reserves a place for all of them in each bucket, puts their
// numbers into the order of the buckets, and copies them in that order, so that neighbours are written by neighbours.
// The spheres stand in the order of the parents of these buckets, so that a tile meets few of them.
#define ID_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_SPLIT_ID) restrict readonly buffer FromIdBuffer { uint from_id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint next_place[]; };
layout(local_size_x = BLOCK) in;
shared uint place[BUCKETS_AT_MOST];  // of the next sphere of each bucket, in the tile
shared uint shift[BUCKETS_AT_MOST];  // from there to its place among all
shared uint order[SORT_TILE];        // the spheres of the tile by bucket: bucket, number in the tile
shared uint sums[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * SORT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SORT_TILE, p.n);
  uint bucket[SORT_TILE / SPLIT_BLOCK];
  for (uint k = 0u; k < SORT_TILE / SPLIT_BLOCK; ++k)
    bucket[k] = slot_of(position[min(first + k * BLOCK + lane, end - 1u)], p) >> p.bucket_shift;
  uint last_bucket = bucket_above(slot_of(position[end - 1u], p), p);
  for (uint low = bucket_below(slot_of(position[first], p), p); low <= last_bucket; low += BUCKETS_AT_MOST) {
    place[lane] = 0u;
    barrier();
    for (uint k = 0u; k < SORT_TILE / SPLIT_BLOCK; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST) atomicAdd(place[bucket[k] - low], 1u);
    barrier();
    uint own = place[lane];
    uint upto = own;
    for (uint step = 1u; step < BLOCK; step *= 2u) {
      sums[lane] = upto;
      barrier();
      if (lane >= step) upto += sums[lane - step];
      barrier();
    }
    sums[lane] = upto;
    place[lane] = upto - own;
    if (own != 0u) shift[lane] = atomicAdd(next_place[p.first_bucket + low + lane], own) - (upto - own);
    barrier();
    for (uint k = 0u; k < SORT_TILE / SPLIT_BLOCK; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        order[atomicAdd(place[bucket[k] - low], 1u)] = (bucket[k] - low) * SORT_TILE + k * BLOCK + lane;
    barrier();
    for (uint q = lane; q < sums[BLOCK - 1u]; q += BLOCK) {
      uint i = first + order[q] % SORT_TILE;
      uint at = q + shift[order[q] / SORT_TILE];
      sorted[at] = position[i];
      id[at] = p.named == 0u ? i : from_id[i];
    }
    barrier();
  }
}
