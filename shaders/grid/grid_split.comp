#version 450
// SPDX-License-Identifier: MIT
// One group per SPLIT_TILE spheres: counts them by bucket, reserves a range of each bucket, sorts their indices by
// bucket in shared memory, and copies the spheres in that order, so that writes are coalesced. The spheres are sorted
// by the parents of these buckets, so that a tile has few buckets.
#define ID_ACCESS
#include "shaders/grid/grid.glsl"
#include "shaders/grid/group_sum.glsl"

layout(std430, binding = SLOT_SPLIT_ID) restrict readonly buffer FromIdBuffer { uint from_id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;
shared uint cursor[BUCKETS_AT_MOST];  // of each bucket in `order`; then the offset from there to the bucket's range
shared uint order[SPLIT_TILE];        // the spheres of the tile by bucket: bucket, index in the tile
shared uint taken;                    // spheres of this pass

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(position[min(first + k * BLOCK + lane, end - 1u)], DENSE, p.grid) >> p.sort.bucket_shift;
  bool parents = p.sort.parent_shift < ONE_PARENT;
  uint last_bucket = bucket_above(parents ? slot_of(position[end - 1u], DENSE, p.grid) : 0u, p.sort);
  uint low = parents ? bucket_below(slot_of(position[first], DENSE, p.grid), p.sort) : 0u;
  for (; low <= last_bucket; low += BUCKETS_AT_MOST) {
    cursor[lane] = 0u;
    barrier();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST) atomicAdd(cursor[bucket[k] - low], 1u);
    barrier();
    uint own = cursor[lane];
    uint upto = sum_up_to(own);
    if (lane == BLOCK - 1u) taken = upto;
    cursor[lane] = upto - own;
    uint shift = own != 0u ? atomicAdd(bucket_cursor[p.sort.first_bucket + low + lane], own) - (upto - own) : 0u;
    barrier();
    for (uint k = 0u; k < SPLIT_EACH; ++k)
      if (first + k * BLOCK + lane < end && bucket[k] - low < BUCKETS_AT_MOST)
        order[atomicAdd(cursor[bucket[k] - low], 1u)] = (bucket[k] - low) * SPLIT_TILE + k * BLOCK + lane;
    barrier();
    cursor[lane] = shift;
    barrier();
    for (uint q = lane; q < taken; q += BLOCK) {
      uint i = first + order[q] % SPLIT_TILE;
      uint at = q + cursor[order[q] / SPLIT_TILE];
      vec4 sphere = position[i];
      bool in_w = p.sort.index_in_w != 0u;
      uint index = p.sort.index_given == 0u ? i : in_w ? float_bits(sphere.w) : from_id[i];
      if (in_w) sphere.w = bits_float(index);
      if (!in_w) id[at] = index;
      sorted[at] = sphere;
    }
    barrier();
  }
}
