// SPDX-License-Identifier: MIT
// One thread per sphere and group of other spheres: tests the sphere against that group in a single loop (the paper's
// two-dimensional arrangement).
#include "cuda/collide/collide.cuh"

namespace spherepair {

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_square(Params p, KernelBuffers buf) {
  __shared__ vec4 tile[BLOCK];
  Collider<EQUAL_RADII, LISTED> collider(p, buf);
  uint lane = threadIdx.x;
  uint groups = (p.n + BLOCK - 1u) / BLOCK;
  uint mine_group = p.first_group + blockIdx.x;
  uint other_group = blockIdx.y + MAX_GROUPS * blockIdx.z;
  if (mine_group >= groups || other_group >= groups) return;
  uint i = mine_group * BLOCK + lane;
  uint first = other_group * BLOCK;
  vec4 mine = buf.position[min(i, p.n - 1u)];
  tile[lane] = buf.position[min(first + lane, p.n - 1u)];
  collider.start_totals();
  uint contacts = 0u;
  uint others = min(uint(BLOCK), p.n - first);
  for (uint k = 0u; k < others; ++k) {
    if (collider.in_reach(mine, tile[k])) contacts += collider.test_ordered_pair(i, mine, first + k, tile[k]);
  }
  if (contacts != 0u) collider.add_contact(i, contacts);
  collider.finish_totals();
}

Entry collide_square_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_square<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
