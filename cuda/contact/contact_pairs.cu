// SPDX-License-Identifier: MIT
// One thread per near pair, in turns until none is left: what the two spheres give each other in a step. There are
// pair_capacity of them, in any order; momenta are loaded only where there is a contact whose damper needs them.
#include "cuda/contact/contact_state.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) contact_pairs(Params p, KernelBuffers buf) {
  uint pairs = p.search.pair_capacity;
  for (uint k = group_index(p) * BLOCK + threadIdx.x; k < pairs; k += group_count() * BLOCK) {
    uint i = buf.near[k].x;
    uint j = buf.near[k].y;
    Body a = load_place(p, buf, i);
    Body b = load_place(p, buf, j);
    if (!in_contact(gap_between(a, b, p.contact))) continue;
    if (p.contact.damping != 0.0f) {
      a = with_momentum(p, buf, a, i);
      b = with_momentum(p, buf, b, j);
    }
    Push push = push_of_pair(a, b, p.contact);
    record_fault(buf, push.fault, i);
    add_impulse(p, buf, i, push.x, push.y, push.z);
    add_impulse(p, buf, j, -push.x, -push.y, -push.z);
  }
}

Entry contact_pairs_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_pairs); }

}  // namespace spherepair
