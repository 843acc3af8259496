#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups shares out a list of clusters, or all; one thread per sphere.
#define VISIBLE_ACCESS  // what was seen long ago hides as well
#include "shaders/draw/batch.glsl"

layout(std430, binding = SLOT_CLUSTER_LIST) restrict readonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;
const uint at_once = BLOCK / CLUSTER;

void main() {
  uint list = list_of(v.phase);
  bool all = !BUNDLES && v.phase == PHASE_ALL;  // bundles are of more
  uint count = all ? v.clusters : drawn[DRAWN_CLUSTERS + list];
  for (uint first = group_index() * at_once; first < count; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x / CLUSTER;
    uint cluster = place_in_turn(k, count, v);
    if (!all && k < count) cluster = cluster_list[list * v.clusters + k];
    uint sorted_index = cluster * CLUSTER + gl_LocalInvocationID.x % CLUSTER;
    draw_batch(sorted_index, k < count && sorted_index < p.n);
  }
}
