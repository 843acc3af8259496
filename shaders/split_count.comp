#version 450
// SPDX-License-Identifier: MIT
// A group takes SPLIT_TILE spheres and counts how many go into each bucket. The spheres stand in the order of the
// parents of these buckets, so that a tile meets few of them. Where there is one split only, the group that is done
// last makes of the counts the places where the buckets begin, a bucket a thread, and clears counts and results.
#define SORTS_SPHERES
#include "grid.glsl"
#include "group_sum.glsl"

layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint next_place[]; };
layout(local_size_x = BLOCK) in;
shared uint counted[BUCKETS_AT_MOST];

// Where the counts begin.
#ifdef ONLY_SPLIT
uint counts_at() { return BUCKETS_AT_MOST; }

// Of SLOT_BUCKET: BUCKETS_AT_MOST places, as many counts, and how many groups have counted.
shared uint groups_before;
void finish_split(uint groups) {
  uint lane = gl_LocalInvocationID.x;
  memoryBarrierBuffer();
  barrier();
  if (lane == 0u) groups_before = atomicAdd(next_place[2u * BUCKETS_AT_MOST], 1u);
  barrier();
  if (groups_before + 1u != groups) return;
  memoryBarrierBuffer();
  uint own = atomicExchange(next_place[BUCKETS_AT_MOST + lane], 0u);
  next_place[lane] = sum_up_to(own) - own;
  if (lane == 0u) next_place[2u * BUCKETS_AT_MOST] = 0u;
  for (uint k = lane; k < SUMMARY_SLOTS * SUMMARY_WORDS; k += BLOCK) summary[k] = 0u;
}
#else
uint counts_at() { return p.first_bucket; }
#endif

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  uint last_bucket = bucket_above(slot_of(sphere_of(end - 1u), p), p);
  vec4 sphere[SPLIT_EACH];  // all on their way before the first is asked for its cell
  for (uint k = 0u; k < SPLIT_EACH; ++k) sphere[k] = sphere_of(min(first + k * BLOCK + lane, end - 1u));
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k) bucket[k] = slot_of(sphere[k], p) >> p.bucket_shift;
  for (uint low = bucket_below(slot_of(sphere_of(first), p), p); low <= last_bucket; low += BUCKETS_AT_MOST) {
    for (uint b = lane; b < BUCKETS_AT_MOST; b += BLOCK) counted[b] = 0u;
    barrier();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST) atomicAdd(counted[bucket[k] - low], 1u);
    barrier();
    for (uint b = lane; b < BUCKETS_AT_MOST; b += BLOCK)
      if (counted[b] != 0u) atomicAdd(next_place[counts_at() + low + b], counted[b]);
    barrier();
  }
#ifdef ONLY_SPLIT
  finish_split((p.n + SPLIT_TILE - 1u) / SPLIT_TILE);
#endif
}
