// SPDX-License-Identifier: MIT
// BOUNDS_LANES threads per cluster, each of which goes through as large a share of its spheres: the box that holds
// them.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline vec4 min(vec4 a, vec4 b) {
  return {smaller(a.x, b.x), smaller(a.y, b.y), smaller(a.z, b.z), smaller(a.w, b.w)};
}
__device__ inline vec4 max(vec4 a, vec4 b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z), larger(a.w, b.w)};
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_bounds(Params p, World w, View) {
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
  for (uint half_size = BOUNDS_LANES / 2u; half_size > 0u; half_size /= 2u) {
    __syncthreads();
    if (own_lane < half_size) {
      low[lane] = min(low[lane], low[lane + half_size]);
      high[lane] = max(high[lane], high[lane + half_size]);
    }
  }
  if (own_lane != 0u || c * CLUSTER >= p.n) return;
  w.cluster[2u * c] = low[lane];
  w.cluster[2u * c + 1u] = high[lane];
}

Entry draw_bounds_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_bounds); }

}  // namespace spherepair
