#version 450
// SPDX-License-Identifier: MIT
// One thread per cluster: it is listed to be drawn, unless it is out of view or hidden by what is drawn already.
#include "listing.glsl"

layout(std430, binding = SLOT_CLUSTER) restrict readonly buffer ClusterBuffer { vec4 cluster[]; };
layout(std430, binding = SLOT_CLUSTER_LIST) restrict writeonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;

bool is_hidden(Solid solid) {
  if (reaches_eye_plane(solid)) return false;
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return true;
  return is_hidden(box, least_depth(solid, box, v), level_for(box));
}

void count_clusters(uint word) {
  if (v.counting != 0u) atomicAdd(drawn[word], 1u);
}

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  bool exists = k < v.clusters;
  uint c = exists ? place_in_turn(k, v.clusters, v) : 0u;
  vec4 low = cluster[2u * c];
  vec4 high = cluster[2u * c + 1u];
  Solid solid = solid_of(low, high, v);
  bool out_of_view = low.x > high.x || outside(solid, v);
  bool draws = exists && !out_of_view && !(v.occlusion != 0u && is_hidden(solid));
  if (exists && !draws) count_clusters(out_of_view ? DRAWN_CLUSTERS_OUTSIDE : DRAWN_CLUSTERS_HIDDEN);
  uint place = place_in_list(DRAWN_CLUSTERS, draws);
  if (draws) cluster_list[place] = c;
}
