#version 450
// SPDX-License-Identifier: MIT
// One group of CLUSTER threads per cluster, one thread per sphere: the box that holds them all.
#include "buffers.glsl"
#include "cluster.h"

layout(std430, binding = SLOT_CLUSTER) restrict writeonly buffer ClusterBuffer { vec4 cluster[]; };
layout(local_size_x = BLOCK) in;
shared vec4 low[CLUSTER];
shared vec4 high[CLUSTER];

void main() {
  uint lane = gl_LocalInvocationID.x;
  vec4 sphere = position[min(group_index() * CLUSTER + lane, p.n - 1u)];
  float most = bits_float(0x7F7FFFFFu);
  bool counts = ever_drawable(sphere);
  low[lane] = counts ? lowest_corner(sphere) : vec4(most);
  high[lane] = counts ? highest_corner(sphere) : vec4(-most);
  for (uint half_size = CLUSTER / 2u; half_size > 0u; half_size /= 2u) {
    barrier();
    if (lane < half_size) {
      low[lane] = min(low[lane], low[lane + half_size]);
      high[lane] = max(high[lane], high[lane + half_size]);
    }
  }
  if (lane != 0u || group_index() * CLUSTER >= p.n) return;
  cluster[2u * group_index()] = low[0];
  cluster[2u * group_index() + 1u] = high[0];
}
