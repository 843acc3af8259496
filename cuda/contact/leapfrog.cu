// SPDX-License-Identifier: MIT
// One thread per sphere: makes a step of the leapfrog, by the impulses of its contacts, of walls and of gravity. A
// sphere that cannot make the step stays where it is and is recorded; later steps then do nothing. Steps also do
// nothing once a sphere has left its skin, until near pairs are listed again. Clears the results of the last search if
// they are by sphere index. A sphere at rest stays as it is.
#include "cuda/contact/contact_impulse.cuh"
#include "cuda/contact/contact_rest.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) leapfrog(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (p.motion.clear_results != 0u) clear_results(p, buf, i);
  if (i >= p.n) return;
  if (is_at_rest(p, buf, i)) {
    if (i == 0u && has_faults(buf)) atomicMin(&buf.fault[LEFT_SKIN], i);
    return;
  }
  Body before = load_body(p, buf, i);  // all loads are issued before the first branch that waits for one
  Push contacts = load_impulse(buf, i);
  vec4 skin = buf.grown[i];
  if (buf.fault[STOPPED] != 0u) return;
  clear_impulses(buf, i, contacts);
  Push walls = push_of_walls(before, (p.contact.sleeping & TESTS_ALL_WALLS) != 0u, p.contact);
  record_fault(buf, walls.fault, i);
  Body s = kicked_in_fluid(before, contacts, walls, p.contact);
  float mobility = mobility_of(s.radius, p.contact);
  vec4 speeds = speeds_of(s, mobility);
  uint wrong = fault_of(s, speeds, p.contact);
  record_fault(buf, wrong, i);
  if (wrong == FAULTS) s = drifted(s, speeds, mobility, p.contact);
  record_rest(p, buf, i, is_same(s, before));
  store_body(p, buf, i, s, speeds);
  bool failed = walls.fault != FAULTS || wrong != FAULTS || (i == 0u && has_faults(buf));
  if (failed || has_left_skin(centre_of(s, p.contact), skin, p.contact)) atomicMin(&buf.fault[LEFT_SKIN], i);
}

Entry leapfrog_kernel(uint, Variant) { return reinterpret_cast<Entry>(&leapfrog); }

}  // namespace spherepair
