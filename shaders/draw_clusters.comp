#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out a list of clusters; one thread per sphere.
#define VISIBLE_ACCESS  // what was seen long ago hides as well
#include "batch.glsl"

layout(std430, binding = SLOT_CLUSTER_LIST) restrict readonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;
const uint at_once = BATCH / CLUSTER;

void main() {
  uint list = list_of(v.phase);
  uint count = drawn[DRAWN_CLUSTERS + list];
  for (uint first = group_index() * at_once; first < count; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x / CLUSTER;
    uint place = k < count ? cluster_list[list * v.clusters + k] * CLUSTER + gl_LocalInvocationID.x % CLUSTER : p.n;
    draw_batch(place, place < p.n);
  }
}
