#version 450
// SPDX-License-Identifier: MIT
// Where one group tells all buckets apart, nothing need be counted before the split: a group takes SPLIT_TILE spheres,
// puts their numbers into the order of the buckets, copies them in that order to where the tile stood, and writes where
// in it each bucket is. grid_sort collects the spheres of its bucket from all tiles. The search before may be under way
// still: nothing that it reads is written here, and nothing that it writes is read.
#define ID_ACCESS
#define SORTS_SPHERES
#include "shaders/grid/grid.glsl"
#include "shaders/grid/group_sum.glsl"

layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_BUCKET) restrict writeonly buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;
shared uint sorted_index[BUCKETS_AT_MOST];  // in the tile: where each bucket begins; counts before that
shared uint order[SPLIT_TILE];              // the spheres of the tile by bucket: their numbers in it

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  sorted_index[lane] = 0u;
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(sphere_of(min(first + k * BLOCK + lane, end - 1u)), DENSE, p) >> p.bucket_shift;
  barrier();
  uint rank[SPLIT_EACH];  // in the bucket, of the tile's spheres
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * BLOCK + lane < end) rank[k] = atomicAdd(sorted_index[bucket[k]], 1u);
  barrier();
  uint own = sorted_index[lane];
  uint upto = sum_up_to(own);
  bucket_cursor[group_index() * BUCKETS_AT_MOST + lane] = run_in_tile(upto - own, upto);
  sorted_index[lane] = upto - own;
  barrier();
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * BLOCK + lane < end) order[sorted_index[bucket[k]] + rank[k]] = k * BLOCK + lane;
  barrier();
  for (uint at = first + lane; at < end; at += BLOCK) {
    uint i = first + order[at - first];
    vec4 sphere = sphere_of(i);
    if ((p.indices & INDEX_IN_W) != 0u) {
      sphere.w = bits_float(i);
    } else {
      id[at] = i;
    }
    sorted[at] = sphere;
  }
}
