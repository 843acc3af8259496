// SPDX-License-Identifier: MIT
// One thread per sphere: it is tested against all others, which pass through shared memory a tile at a time, for
// contact at any time within the next step.
#include "common/shared/swept.h"
#include "cuda/collide/collide.cuh"

namespace spherepair {

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_swept(Params p, KernelBuffers buf) {
  __shared__ vec4 tile[BLOCK];
  __shared__ vec4 tile_velocity[BLOCK];
  Collider<EQUAL_RADII, LISTED> collider(p, buf);
  uint lane = threadIdx.x;
  uint i = group_index(p) * BLOCK + lane;
  vec4 mine = buf.position[min(i, p.n - 1u)];
  vec4 my_velocity = buf.velocity[min(i, p.n - 1u)];
  collider.start_totals();
  uint contacts = 0u;
  for (uint first = 0u; first < p.n; first += BLOCK) {
    tile[lane] = buf.position[min(first + lane, p.n - 1u)];
    tile_velocity[lane] = buf.velocity[min(first + lane, p.n - 1u)];
    __syncthreads();
    uint others = min(uint(BLOCK), p.n - first);
    for (uint k = 0u; k < others; ++k) {
      uint j = first + k;
      if (i >= p.n || i == j) continue;
      if (!in_swept_reach(mine, my_velocity, tile[k], tile_velocity[k], p.motion.dt)) continue;
      if (!touch_within(mine, my_velocity, tile[k], tile_velocity[k], p.motion.dt, p.search.filter_scale,
                        p.search.filter_offset))
        continue;
      contacts += 1u;
      if (i < j) collider.record(i, j);
    }
    __syncthreads();
  }
  if (contacts != 0u) collider.add_contact(i, contacts);
  collider.finish_totals();
}

Entry collide_swept_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto, auto listed) {
    return reinterpret_cast<Entry>(&collide_swept<size(), false, listed()>);
  });
}

}  // namespace spherepair
