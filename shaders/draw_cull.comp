#version 450
// SPDX-License-Identifier: MIT
// One thread per cluster: whether it is drawn in the second phase, and whether the next picture draws it in the first.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(std430, binding = SLOT_CLUSTER) restrict readonly buffer ClusterBuffer { vec4 cluster[]; };
layout(std430, binding = SLOT_CLUSTER_SEEN) restrict buffer ClusterSeenBuffer { uint cluster_seen[]; };
layout(std430, binding = SLOT_CLUSTER_LIST) restrict writeonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(std430, binding = SLOT_PYRAMID) restrict readonly buffer PyramidBuffer { uint pyramid[]; };
layout(local_size_x = BLOCK) in;
shared uint entries[2];  // of the group: clusters to draw, and to draw first in the next picture
shared uint first_entry[2];

bool hidden(Solid solid) {
  if (reaches_eye_plane(solid)) return false;
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return true;
  uint level = texels_of(box, 0u) > uint(TEXELS_AT_MOST) ? 1u : 0u;
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return false;
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  uint nearest = least_depth(solid, box, v);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (pyramid[first + y * width + x] >= nearest) return false;
  return true;
}

void count_clusters(uint word) {
  if (v.counting != 0u) atomicAdd(drawn[word], 1u);
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint k = group_index() * BLOCK + lane;
  bool exists = k < v.clusters;
  uint c = exists ? place_in_turn(k, v.clusters, v) : 0u;
  vec4 low = cluster[2u * c];
  vec4 high = cluster[2u * c + 1u];
  Solid solid = solid_of(low, high, v);
  bool out_of_view = low.x > high.x || outside(solid, v);
  bool first = v.occlusion != 0u && cluster_seen[c] != 0u;
  bool seen = exists && !out_of_view && !(v.occlusion != 0u && hidden(solid));
  bool keeps = seen && v.occlusion != 0u;
  if (exists && v.occlusion != 0u) cluster_seen[c] = seen ? 1u : 0u;
  if (exists && out_of_view) count_clusters(DRAWN_CLUSTERS_OUTSIDE);
  if (exists && !out_of_view && !seen && !first) count_clusters(DRAWN_CLUSTERS_HIDDEN);

  bool draws = seen && !first;
  if (lane < 2u) entries[lane] = 0u;
  barrier();
  uint drawn_place = draws ? atomicAdd(entries[0], 1u) : 0u;
  uint kept_place = keeps ? atomicAdd(entries[1], 1u) : 0u;
  barrier();
  uint next = 1u - v.turn;
  if (lane < 2u && entries[lane] > 0u)
    first_entry[lane] = atomicAdd(drawn[lane == 0u ? DRAWN_CLUSTERS : DRAWN_SEEN + next], entries[lane]);
  barrier();
  if (draws) cluster_list[2u * v.clusters + first_entry[0] + drawn_place] = c;
  if (keeps) cluster_list[next * v.clusters + first_entry[1] + kept_place] = c;
}
