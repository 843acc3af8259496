// SPDX-License-Identifier: MIT
// One thread per listed pair, in turns until none is left: what the two spheres give each other in a step. Pairs come
// from the search of these positions, in any order.
#include "cuda/contact/contact_state.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) contact_pairs(Params p, KernelBuffers buf) {
  uint pairs = min(buf.summary[SUM_LISTED], p.search.pair_capacity);
  for (uint k = group_index(p) * BLOCK + threadIdx.x; k < pairs; k += group_count() * BLOCK) {
    uint i = buf.listed[k].x;
    uint j = buf.listed[k].y;
    Push push = push_of_pair(load_body(p, buf, i), load_body(p, buf, j), p.contact);
    record_fault(buf, push.fault, i);
    add_impulse(p, buf, i, push.x, push.y, push.z);
    add_impulse(p, buf, j, -push.x, -push.y, -push.z);
  }
}

Entry contact_pairs_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_pairs); }

}  // namespace spherepair
