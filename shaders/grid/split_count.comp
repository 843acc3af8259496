#version 450
// SPDX-License-Identifier: MIT
// One group per SPLIT_TILE spheres: counts them by bucket. The spheres are sorted by the parents of these buckets, so
// that a tile has few buckets.
#include "shaders/grid/grid.glsl"

layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;
shared uint counted[BUCKETS_AT_MOST];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  bool parents = p.sort.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(position[end - 1u], DENSE, p.grid) : 0u, p.sort);
  vec4 sphere[SPLIT_EACH];  // all loads are issued before the first cell is computed
  for (uint k = 0u; k < SPLIT_EACH; ++k) sphere[k] = position[min(first + k * BLOCK + lane, end - 1u)];
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k) bucket[k] = slot_of(sphere[k], DENSE, p.grid) >> p.sort.bucket_shift;
  uint low = parents ? bucket_below(slot_of(position[first], DENSE, p.grid), p.sort) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
    for (uint b = lane; b < BUCKETS_AT_MOST; b += BLOCK) counted[b] = 0u;
    barrier();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST) atomicAdd(counted[bucket[k] - low], 1u);
    barrier();
    for (uint b = lane; b < BUCKETS_AT_MOST; b += BLOCK)
      if (counted[b] != 0u) atomicAdd(bucket_cursor[p.sort.first_bucket + low + b], counted[b]);
    barrier();
  }
}
