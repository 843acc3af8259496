// SPDX-License-Identifier: MIT
// One thread, or LANES threads, per sphere: it is drawn, unless it is large, which draw_tiles then does.
#include "cuda/draw/visible.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_spheres(Params p, KernelBuffers w, View v) {
  uint k = group_index(p) * (SERVICE_BLOCK / v.lanes) + threadIdx.x / v.lanes;
  if (k >= p.n) return;
  uint lane = threadIdx.x % v.lanes;
  Walk walk = walk_of(p, w, v, place_in_turn(k, p.n, v), lane == 0u);
  draw_walk(w, v, walk, lane, v.lanes, lanes_across(v));
}

Entry draw_spheres_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_spheres); }

}  // namespace spherepair
