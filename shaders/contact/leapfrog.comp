#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: makes a step of the leapfrog, by the impulses of its contacts, of walls and of gravity. A
// sphere that cannot make the step stays where it is and is recorded; later steps then do nothing. Steps also do
// nothing once a sphere has left its skin, until near pairs are listed again. Clears the results of the last search if
// they are by sphere index. A sphere at rest stays as it is.
#include "shaders/contact/contact_impulse.glsl"
#include "shaders/contact/contact_rest.glsl"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_GROWN) restrict readonly buffer GrownBuffer { vec4 grown[]; };

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (p.motion.clear_results != 0u) clear_results(i);
  if (i >= p.n) return;
  if (is_at_rest(i)) {
    if (i == 0u && has_faults()) atomicMin(fault[LEFT_SKIN], i);
    return;
  }
  Body before = load_body(i);  // all loads are issued before the first branch that waits for one
  Push contacts = load_impulse(i);
  vec4 skin = grown[i];
  if (fault[STOPPED] != 0u) return;
  clear_impulses(i, contacts);
  Push walls = push_of_walls(before, (p.contact.sleeping & TESTS_ALL_WALLS) != 0u, p.contact);
  record_fault(walls.fault, i);
  Body s = kicked_in_fluid(before, contacts, walls, p.contact);
  float mobility = mobility_of(s.radius, p.contact);
  vec4 speeds = speeds_of(s, mobility);
  uint wrong = fault_of(s, speeds, p.contact);
  record_fault(wrong, i);
  if (wrong == FAULTS) s = drifted(s, speeds, mobility, p.contact);
  record_rest(i, is_same(s, before));
  store_body(i, s, speeds);
  bool failed = walls.fault != FAULTS || wrong != FAULTS || (i == 0u && has_faults());
  if (failed || has_left_skin(centre_of(s, p.contact), skin, p.contact)) atomicMin(fault[LEFT_SKIN], i);
}
