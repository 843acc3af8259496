// SPDX-License-Identifier: MIT
// One group of CLUSTER threads per cluster, one thread per sphere: the box that holds them all.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline vec4 min(vec4 a, vec4 b) {
  return {smaller(a.x, b.x), smaller(a.y, b.y), smaller(a.z, b.z), smaller(a.w, b.w)};
}
__device__ inline vec4 max(vec4 a, vec4 b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z), larger(a.w, b.w)};
}

__global__ void __launch_bounds__(CLUSTER) draw_bounds(Params p, World w, View) {
  __shared__ vec4 low[CLUSTER];
  __shared__ vec4 high[CLUSTER];
  uint lane = threadIdx.x;
  vec4 sphere = w.position[::min(group_index(p) * CLUSTER + lane, p.n - 1u)];
  float most = bits_float(0x7F7FFFFFu);
  bool counts = ever_drawable(sphere);
  low[lane] = counts ? lowest_corner(sphere) : vec4{most, most, most, most};
  high[lane] = counts ? highest_corner(sphere) : vec4{-most, -most, -most, -most};
  for (uint half_size = CLUSTER / 2u; half_size > 0u; half_size /= 2u) {
    __syncthreads();
    if (lane < half_size) {
      low[lane] = min(low[lane], low[lane + half_size]);
      high[lane] = max(high[lane], high[lane + half_size]);
    }
  }
  if (lane != 0u || group_index(p) * CLUSTER >= p.n) return;
  w.cluster[2u * group_index(p)] = low[0];
  w.cluster[2u * group_index(p) + 1u] = high[0];
}

Entry draw_bounds_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_bounds); }

}  // namespace spherepair
