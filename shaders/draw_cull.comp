#version 450
// SPDX-License-Identifier: MIT
// One thread per cluster: whether it is drawn in this phase, and in the second whether the next picture draws it first.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(std430, binding = SLOT_CLUSTER) restrict readonly buffer ClusterBuffer { vec4 cluster[]; };
layout(std430, binding = SLOT_CLUSTER_SEEN) restrict buffer ClusterSeenBuffer { uint cluster_seen[]; };
layout(std430, binding = SLOT_CLUSTER_LIST) restrict writeonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(std430, binding = SLOT_PYRAMID) restrict readonly buffer PyramidBuffer { uint pyramid[]; };
layout(local_size_x = BLOCK) in;

bool hidden(Solid solid) {
  if (reaches_eye_plane(solid)) return false;
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return true;
  uint level = level_for(box, v);
  uint shift = 3u + 2u * level;
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  uint nearest = least_depth(solid, box, v);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (pyramid[first + y * width + x] >= nearest) return false;
  return true;
}

void count_clusters(uint word) {
  if (v.counting != 0u && v.phase == PHASE_REST) atomicAdd(drawn[word], 1u);
}

void main() {
  uint c = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (c >= v.clusters) return;
  vec4 low = cluster[2u * c];
  vec4 high = cluster[2u * c + 1u];
  Solid solid = solid_of(low, high, v);
  bool out_of_view = low.x > high.x || outside(solid, v);
  bool first = v.occlusion != 0u && !out_of_view && cluster_seen[c] != 0u;
  bool seen = !out_of_view;
  if (v.phase == PHASE_REST && v.occlusion != 0u) {
    seen = seen && !hidden(solid);
    cluster_seen[c] = seen ? 1u : 0u;
  }
  if (out_of_view) count_clusters(DRAWN_CLUSTERS_OUTSIDE);
  if (!out_of_view && !seen && !first) count_clusters(DRAWN_CLUSTERS_HIDDEN);
  if (v.phase == PHASE_SEEN ? first : seen && !first) cluster_list[atomicAdd(drawn[DRAWN_CLUSTERS], 1u)] = c;
}
