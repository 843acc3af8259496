#version 450
// SPDX-License-Identifier: MIT
// BOUNDS_LANES threads per cluster, each of which goes through as large a share of its spheres: the box that holds
// them.
#include "buffers.glsl"
#include "cluster.h"

layout(std430, binding = SLOT_CLUSTER) restrict writeonly buffer ClusterBuffer { vec4 cluster[]; };
layout(local_size_x = BLOCK) in;
shared vec4 low[BLOCK];
shared vec4 high[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint own_lane = lane % BOUNDS_LANES;  // of the cluster's
  uint c = group_index() * (BLOCK / BOUNDS_LANES) + lane / BOUNDS_LANES;
  float most = bits_float(0x7F7FFFFFu);
  low[lane] = vec4(most, most, most, most);
  high[lane] = vec4(-most, -most, -most, -most);
  for (uint k = own_lane; k < CLUSTER && c * CLUSTER + k < p.n; k += BOUNDS_LANES) {
    vec4 sphere = position[c * CLUSTER + k];
    if (!ever_drawable(sphere)) continue;
    low[lane] = min(low[lane], lowest_corner(sphere));
    high[lane] = max(high[lane], highest_corner(sphere));
  }
  for (uint half_size = BOUNDS_LANES / 2u; half_size > 0u; half_size /= 2u) {
    barrier();
    if (own_lane < half_size) {
      low[lane] = min(low[lane], low[lane + half_size]);
      high[lane] = max(high[lane], high[lane + half_size]);
    }
  }
  if (own_lane != 0u || c * CLUSTER >= p.n) return;
  cluster[2u * c] = low[lane];
  cluster[2u * c + 1u] = high[lane];
}
