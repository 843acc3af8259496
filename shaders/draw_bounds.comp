#version 450
// SPDX-License-Identifier: MIT
// BOUNDS_LANES threads per cluster, each of which goes through as large a share of its spheres: the box that holds
// them; and then the box that holds a bundle.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_CLUSTER) restrict writeonly buffer ClusterBuffer { vec4 cluster[]; };
layout(local_size_x = BLOCK) in;
shared vec4 low[BLOCK];
shared vec4 high[BLOCK];

// All threads of the group call it: every second of what stands `stride` apart takes in its neighbour.
void join(uint stride) {
  uint lane = gl_LocalInvocationID.x;
  barrier();
  if (lane % (2u * stride) != 0u) return;
  low[lane] = min(low[lane], low[lane + stride]);
  high[lane] = max(high[lane], high[lane + stride]);
}

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
  for (uint stride = 1u; stride < BOUNDS_LANES; stride *= 2u) join(stride);
  if (own_lane == 0u && c < v.clusters) {
    cluster[2u * c] = low[lane];
    cluster[2u * c + 1u] = high[lane];
  }
  for (uint stride = BOUNDS_LANES; stride < BUNDLE * BOUNDS_LANES; stride *= 2u) join(stride);
  if (own_lane != 0u || c % BUNDLE != 0u || c >= v.clusters) return;
  cluster[corners_of_bundle(c / BUNDLE, v)] = low[lane];
  cluster[corners_of_bundle(c / BUNDLE, v) + 1u] = high[lane];
}
