#version 450
// SPDX-License-Identifier: MIT
// One group per SPLIT_TILE spheres: sorts their indices by bucket in shared memory, copies the spheres in that order
// within their tile, and writes the range of each bucket. With at most BUCKETS_AT_MOST buckets no count across tiles is
// needed: grid_sort collects the spheres of its bucket from all tiles. The previous step's search may still be running:
// it reads nothing that is written here, and writes nothing that is read here.
#define ID_ACCESS
#include "shaders/grid/grid.glsl"
#include "shaders/grid/group_sum.glsl"

layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_BUCKET) restrict writeonly buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;
shared uint cursor[BUCKETS_AT_MOST];  // counts of the buckets, then where each begins in the tile
shared uint order[SPLIT_TILE];        // the spheres of the tile by bucket: index in the tile

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  cursor[lane] = 0u;
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(position[min(first + k * BLOCK + lane, end - 1u)], DENSE, p.grid) >> p.sort.bucket_shift;
  barrier();
  uint rank[SPLIT_EACH];  // among the spheres of its bucket in the tile
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * BLOCK + lane < end) rank[k] = atomicAdd(cursor[bucket[k]], 1u);
  barrier();
  uint own = cursor[lane];
  uint upto = sum_up_to(own);
  bucket_cursor[group_index() * BUCKETS_AT_MOST + lane] = run_in_tile(upto - own, upto);
  cursor[lane] = upto - own;
  barrier();
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * BLOCK + lane < end) order[cursor[bucket[k]] + rank[k]] = k * BLOCK + lane;
  barrier();
  for (uint at = first + lane; at < end; at += BLOCK) {
    uint i = first + order[at - first];
    vec4 sphere = position[i];
    if (p.sort.index_in_w != 0u) {
      sphere.w = bits_float(i);
    } else {
      id[at] = i;
    }
    sorted[at] = sphere;
  }
}
