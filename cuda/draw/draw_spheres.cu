// SPDX-License-Identifier: MIT
// One thread, or LANES threads, per sphere: draws it, or leaves it to draw_tiles if it is large.
#include "cuda/draw/visibility_buffer.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) draw_spheres(Params p, KernelBuffers buf, View v) {
  uint k = group_index(p) * (BLOCK / v.lanes) + threadIdx.x / v.lanes;
  if (k >= p.n) return;
  uint lane = threadIdx.x % v.lanes;
  Footprint footprint = footprint_of(p, buf, v, front_to_back(k, p.n, v), lane == 0u);
  draw_footprint(buf, v, footprint, lane, v.lanes, lanes_across(v));
}

Entry draw_spheres_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_spheres); }

}  // namespace spherepair
