#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out the list of clusters to draw; one thread per sphere.
#define VISIBLE_ACCESS  // what was seen long ago hides as well
#include "batch.glsl"

layout(std430, binding = SLOT_CLUSTER_LIST) restrict readonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;
const uint at_once = BATCH / CLUSTER;

void main() {
  uint count = drawn[DRAWN_CLUSTERS];
  for (uint first = group_index() * at_once; first < count; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x / CLUSTER;
    uint place = k < count ? cluster_list[k] * CLUSTER + gl_LocalInvocationID.x % CLUSTER : p.n;
    draw_batch(place, place < p.n);
  }
}
