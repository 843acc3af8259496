// SPDX-License-Identifier: MIT
// BOUNDS_LANES threads per cluster share its spheres: they compute the bounding box of each cluster, then of each
// bundle. By cells, one thread per cluster derives the box from the cells in which this cluster and the next one begin,
// and reads all spheres only if these are not in one row of cells.
#include "common/shared/cluster.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

// CUDA only from here: GLSL has them
__device__ inline vec4 min(vec4 a, vec4 b) {
  return {smaller(a.x, b.x), smaller(a.y, b.y), smaller(a.z, b.z), smaller(a.w, b.w)};
}
__device__ inline vec4 max(vec4 a, vec4 b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z), larger(a.w, b.w)};
}
// until here

__shared__ vec4 low[BLOCK];
__shared__ vec4 high[BLOCK];

// Makes a step of the reduction: joins every second box `stride` apart with its neighbour. All threads of the group
// must call it.
__device__ inline void join(uint stride) {
  uint lane = threadIdx.x;
  __syncthreads();
  if (lane % (2u * stride) != 0u) return;
  low[lane] = min(low[lane], low[lane + stride]);
  high[lane] = max(high[lane], high[lane + stride]);
}

template <bool BY_CELLS>
__global__ void __launch_bounds__(BLOCK) draw_bounds(Params p, KernelBuffers buf, View v) {
  constexpr uint lanes = BY_CELLS ? 1u : BOUNDS_LANES;
  uint lane = threadIdx.x;
  uint own_lane = lane % lanes;  // within the cluster
  uint c = group_index(p) * (BLOCK / lanes) + lane / lanes;
  float most = bits_float(0x7F7FFFFFu);
  low[lane] = vec4{most, most, most, most};
  high[lane] = vec4{-most, -most, -most, -most};
  bool in_row = false;
  if (BY_CELLS && c < v.clusters) {
    GridPosition begin = grid_position(buf.position[c * CLUSTER], p.grid);
    uint next = (c + 1u) * CLUSTER;
    GridPosition end = grid_position(buf.position[next < p.n ? next : p.n - 1u], p.grid);
    in_row = within_row(begin, end, p.grid);
    if (in_row) low[lane] = lowest_in_row(begin, p.grid);
    if (in_row) high[lane] = highest_in_row(end, p.grid);
  }
  for (uint k = own_lane; !in_row && k < CLUSTER; k += 4u * lanes) {
    vec4 four[4];  // all loads are issued before the first is used; past the end the last sphere repeats
    for (uint j = 0u; j < 4u; ++j) {
      uint i = c * CLUSTER + k + j * lanes;
      four[j] = with_radius(p, buf.position[i < p.n ? i : p.n - 1u]);
    }
    for (uint j = 0u; j < 4u; ++j) {
      if (!ever_drawable(four[j])) continue;
      low[lane] = min(low[lane], lowest_corner(four[j]));
      high[lane] = max(high[lane], highest_corner(four[j]));
    }
  }
  for (uint stride = 1u; stride < lanes; stride *= 2u) join(stride);
  if (own_lane == 0u && c < v.clusters) {
    buf.cluster[2u * c] = low[lane];
    buf.cluster[2u * c + 1u] = high[lane];
  }
  for (uint stride = lanes; stride < BUNDLE * lanes; stride *= 2u) join(stride);
  if (own_lane != 0u || c % BUNDLE != 0u || c >= v.clusters) return;
  buf.cluster[corners_of_bundle(c / BUNDLE, v)] = low[lane];
  buf.cluster[corners_of_bundle(c / BUNDLE, v) + 1u] = high[lane];
}

Entry draw_bounds_kernel(uint, Variant variant) {
  return variant.by_cells ? reinterpret_cast<Entry>(&draw_bounds<true>) : reinterpret_cast<Entry>(&draw_bounds<false>);
}

}  // namespace spherepair
