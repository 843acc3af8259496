// SPDX-License-Identifier: MIT
// One thread per sphere: every group of spheres passes through shared memory, and it meets them all (the paper's code
// 5).
#include "cuda/collide/collide.cuh"

namespace spherepair {

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_tiled(Params p, KernelBuffers w) {
  __shared__ vec4 tile[BLOCK];
  __shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];
  Collider<EQUAL_RADII, LISTED> c(p, w, total);
  uint lane = threadIdx.x;
  uint i = group_index(p) * BLOCK + lane;
  vec4 mine = w.position[min(i, p.n - 1u)];
  c.start_totals();
  uint contacts = 0u;
  for (uint first = 0u; first < p.n; first += BLOCK) {
    tile[lane] = w.position[min(first + lane, p.n - 1u)];
    __syncthreads();
    uint others = min(uint(BLOCK), p.n - first);
    for (uint k = 0u; k < others; ++k) {
      if (c.in_reach(mine, tile[k])) contacts += c.test_ordered_pair(i, mine, first + k, tile[k]);
    }
    __syncthreads();
  }
  if (contacts != 0u) c.add_contact(i, contacts);
  c.finish_totals();
}

Entry collide_tiled_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_tiled<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
