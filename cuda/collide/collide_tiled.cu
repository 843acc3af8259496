// SPDX-License-Identifier: MIT
// One thread per sphere: tests it against all others, which pass through shared memory a tile at a time (the paper's
// code 5).
#include "cuda/collide/collide.cuh"

namespace spherepair {

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_tiled(Params p, KernelBuffers buf) {
  __shared__ vec4 tile[BLOCK];
  Collider<EQUAL_RADII, LISTED> collider(p, buf);
  uint lane = threadIdx.x;
  uint i = group_index(p) * BLOCK + lane;
  vec4 mine = buf.position[min(i, p.n - 1u)];
  collider.start_totals();
  uint contacts = 0u;
  for (uint first = 0u; first < p.n; first += BLOCK) {
    tile[lane] = buf.position[min(first + lane, p.n - 1u)];
    __syncthreads();
    uint others = min(uint(BLOCK), p.n - first);
    for (uint k = 0u; k < others; ++k) {
      if (collider.in_reach(mine, tile[k])) contacts += collider.test_ordered_pair(i, mine, first + k, tile[k]);
    }
    __syncthreads();
  }
  if (contacts != 0u) collider.add_contact(i, contacts);
  collider.finish_totals();
}

Entry collide_tiled_kernel(uint block, Variant variant) {
  return pick_small_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_tiled<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
