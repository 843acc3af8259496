// SPDX-License-Identifier: MIT
// One thread per sphere: every group of spheres passes through shared memory, and it meets them all on the way that
// both take in the next step.
#include "common/shared/swept.h"
#include "cuda/collide/collide.cuh"

namespace spherepair {

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_swept(Params p, KernelBuffers w) {
  __shared__ vec4 tile[BLOCK];
  __shared__ vec4 tile_velocity[BLOCK];
  __shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];
  Collider<EQUAL_RADII, LISTED> c(p, w, total);
  uint lane = threadIdx.x;
  uint i = group_index(p) * BLOCK + lane;
  vec4 mine = w.position[min(i, p.n - 1u)];
  vec4 my_velocity = w.velocity[min(i, p.n - 1u)];
  c.start_totals();
  uint contacts = 0u;
  for (uint first = 0u; first < p.n; first += BLOCK) {
    tile[lane] = w.position[min(first + lane, p.n - 1u)];
    tile_velocity[lane] = w.velocity[min(first + lane, p.n - 1u)];
    __syncthreads();
    uint others = min(uint(BLOCK), p.n - first);
    for (uint k = 0u; k < others; ++k) {
      uint j = first + k;
      if (i >= p.n || i == j) continue;
      if (!in_swept_reach(mine, my_velocity, tile[k], tile_velocity[k], p.dt)) continue;
      if (!touch_within(mine, my_velocity, tile[k], tile_velocity[k], p.dt, p.filter_scale, p.filter_offset)) continue;
      contacts += 1u;
      if (i < j) c.record(i, j);
    }
    __syncthreads();
  }
  if (contacts != 0u) c.add_contact(i, contacts);
  c.finish_totals();
}

Entry collide_swept_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto, auto listed) {
    return reinterpret_cast<Entry>(&collide_swept<size(), false, listed()>);
  });
}

}  // namespace spherepair
