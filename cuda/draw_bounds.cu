// SPDX-License-Identifier: MIT
// BOUNDS_LANES threads per cluster, each of which goes through as large a share of its spheres: the box that holds
// them; and then the box that holds a bundle.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline vec4 min(vec4 a, vec4 b) {
  return {smaller(a.x, b.x), smaller(a.y, b.y), smaller(a.z, b.z), smaller(a.w, b.w)};
}
__device__ inline vec4 max(vec4 a, vec4 b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z), larger(a.w, b.w)};
}

// All threads of the group call it: every second of what stands `stride` apart takes in its neighbour.
__device__ inline void join(vec4* low, vec4* high, uint stride) {
  uint lane = threadIdx.x;
  __syncthreads();
  if (lane % (2u * stride) != 0u) return;
  low[lane] = min(low[lane], low[lane + stride]);
  high[lane] = max(high[lane], high[lane + stride]);
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_bounds(Params p, World w, View v) {
  __shared__ vec4 low[SERVICE_BLOCK];
  __shared__ vec4 high[SERVICE_BLOCK];
  uint lane = threadIdx.x;
  uint own_lane = lane % BOUNDS_LANES;  // of the cluster's
  uint c = group_index(p) * (SERVICE_BLOCK / BOUNDS_LANES) + lane / BOUNDS_LANES;
  float most = bits_float(0x7F7FFFFFu);
  low[lane] = vec4{most, most, most, most};
  high[lane] = vec4{-most, -most, -most, -most};
  for (uint k = own_lane; k < CLUSTER && c * CLUSTER + k < p.n; k += BOUNDS_LANES) {
    vec4 sphere = w.position[c * CLUSTER + k];
    if (!ever_drawable(sphere)) continue;
    low[lane] = min(low[lane], lowest_corner(sphere));
    high[lane] = max(high[lane], highest_corner(sphere));
  }
  for (uint stride = 1u; stride < BOUNDS_LANES; stride *= 2u) join(low, high, stride);
  if (own_lane == 0u && c < v.clusters) {
    w.cluster[2u * c] = low[lane];
    w.cluster[2u * c + 1u] = high[lane];
  }
  for (uint stride = BOUNDS_LANES; stride < BUNDLE * BOUNDS_LANES; stride *= 2u) join(low, high, stride);
  if (own_lane != 0u || c % BUNDLE != 0u || c >= v.clusters) return;
  w.cluster[corners_of_bundle(c / BUNDLE, v)] = low[lane];
  w.cluster[corners_of_bundle(c / BUNDLE, v) + 1u] = high[lane];
}

Entry draw_bounds_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_bounds); }

}  // namespace spherepair
