#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere; a fixed number of groups loops over a list of clusters, or all of them, and draws the spheres.
#define VISIBLE_ACCESS  // a stale depth only costs time
#include "shaders/draw/batch.glsl"

layout(std430, binding = SLOT_CLUSTER_LIST) restrict readonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;
const uint at_once = BLOCK / CLUSTER;

void main() {
  uint list = list_of(v.phase);
  bool all = !BUNDLES && v.phase == PHASE_ALL;  // bundles are for more clusters
  uint count = all ? v.clusters : drawn[DRAWN_CLUSTERS + list];
  for (uint first = group_index() * at_once; first < count; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x / CLUSTER;
    uint cluster = front_to_back(k, count, v);
    if (!all && k < count) cluster = cluster_list[list * v.clusters + k];
    uint i = cluster * CLUSTER + gl_LocalInvocationID.x % CLUSTER;
    draw_batch(i, k < count && i < p.n);
  }
}
