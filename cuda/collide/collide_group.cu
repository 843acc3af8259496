// SPDX-License-Identifier: MIT
// One thread per sphere: tests it against the spheres of its own group, in shared memory (the paper's code 4). Pairs
// across groups are not found.
#include "cuda/collide/collide.cuh"

namespace spherepair {

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_group(Params p, KernelBuffers buf) {
  __shared__ vec4 tile[BLOCK];
  Collider<EQUAL_RADII, LISTED> collider(p, buf);
  uint lane = threadIdx.x;
  uint first = group_index(p) * BLOCK;
  uint i = first + lane;
  vec4 mine = buf.position[min(i, p.n - 1u)];
  tile[lane] = mine;
  collider.start_totals();
  uint contacts = 0u;
  uint others = first < p.n ? min(uint(BLOCK), p.n - first) : 0u;
  for (uint k = 0u; k < others; ++k) {
    if (collider.in_reach(mine, tile[k])) contacts += collider.test_ordered_pair(i, mine, first + k, tile[k]);
  }
  if (contacts != 0u) collider.add_contact(i, contacts);
  collider.finish_totals();
}

Entry collide_group_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_group<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
