#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups of CLUSTER threads shares out the phase's list of clusters; one thread per sphere.
#include "visible.glsl"

layout(std430, binding = SLOT_CLUSTER_LIST) restrict readonly buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;

void main() {
  bool rest = v.phase == PHASE_REST;
  uint first = (rest ? 2u : v.turn) * v.clusters;
  uint count = drawn[rest ? DRAWN_CLUSTERS : DRAWN_SEEN + v.turn];
  for (uint k = group_index(); k < count; k += group_count()) {
    uint place = cluster_list[first + k] * CLUSTER + gl_LocalInvocationID.x;
    if (place < p.n) draw_sphere(place, 0u);
  }
}
