// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: adds the impulses of the two spheres on each other in a step.
// There are near_pairs of them, in any order. Most do not touch, as their float32 centres show; momenta are loaded only
// for contacts whose damper needs them. Pairs of two spheres at rest are skipped; an earlier launch of this kernel
// awakens spheres. Once a sphere has left its skin, later steps do nothing.
#include "cuda/contact/contact_impulse.cuh"
#include "cuda/contact/contact_rest.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) contact_pairs(Params p, KernelBuffers buf) {
  bool stopped = buf.fault[LEFT_SKIN] != 0xFFFFFFFFu;
  uint first = group_index(p) * BLOCK + threadIdx.x;
  if (first == 0u) buf.fault[STOPPED] = stopped ? 1u : 0u;
  bool awakens = sleep_mode(p.contact) == SLEEP_AWAKENS;
  if (first == 0u && !stopped && !awakens) ++buf.fault[STEPS_DONE];
  if (stopped) return;
  uint pairs = p.search.near_pairs;
  for (uint k = first; k < pairs; k += group_count() * BLOCK) {
    uint i = buf.near[k].x;
    uint j = buf.near[k].y;
    if (i == j) continue;  // none
    if (awakens) {
      awaken(buf, i, j);
      continue;
    }
    bool first_rests = is_at_rest(p, buf, i);
    bool second_rests = is_at_rest(p, buf, j);
    if (first_rests && second_rests) continue;
    if (is_apart(buf.position[i], buf.position[j], p.contact)) continue;
    Body a = load_place(p, buf, i);
    Body b = load_place(p, buf, j);
    if (!in_contact(gap_between(a, b, p.contact))) continue;
    if (p.contact.damping != 0.0f) {
      a = load_body(p, buf, i);
      b = load_body(p, buf, j);
    }
    FloatPush push = float_push_of_pair(a, b, p.contact);
    record_fault(buf, push.fault, min(i, j));
    if (!first_rests) add_impulse(buf, i, push.x, push.y, push.z);
    if (!second_rests) add_impulse(buf, j, -push.x, -push.y, -push.z);
  }
}

Entry contact_pairs_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_pairs); }

}  // namespace spherepair
