#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups of CLUSTER threads shares out the list of clusters to draw; one thread per sphere.
#include "visible.glsl"

layout(std430, binding = SLOT_CLUSTER_LIST) restrict readonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint first = v.pass == PASS_ID ? 0u : drawn[DRAWN_CLUSTERS_DONE];
  for (uint k = first + group_index(); k < drawn[DRAWN_CLUSTERS]; k += group_count()) {
    uint place = cluster_list[k] * CLUSTER + gl_LocalInvocationID.x;
    if (place < p.n) draw_sphere(place);
  }
}
