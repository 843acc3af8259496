#version 450
// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: adds the impulses of the two spheres on each other in a step.
// There are near_pairs of them, in any order. Most do not touch, as their float32 centres show; momenta are loaded only
// for contacts whose damper needs them. Pairs of two spheres at rest are skipped; an earlier launch of this kernel
// awakens spheres. Once a sphere has left its skin, later steps do nothing.
#include "shaders/contact/contact_impulse.glsl"
#include "shaders/contact/contact_rest.glsl"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_NEAR) restrict readonly buffer NearBuffer { uvec2 near[]; };

void main() {
  bool stopped = fault[LEFT_SKIN] != 0xFFFFFFFFu;
  uint first = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (first == 0u) fault[STOPPED] = stopped ? 1u : 0u;
  bool awakens = sleep_mode(p.contact) == SLEEP_AWAKENS;
  if (first == 0u && !stopped && !awakens) ++fault[STEPS_DONE];
  if (stopped) return;
  uint pairs = p.search.near_pairs;
  for (uint k = first; k < pairs; k += group_count() * BLOCK) {
    uint i = near[k].x;
    uint j = near[k].y;
    if (i == j) continue;  // none
    if (awakens) {
      awaken(i, j);
      continue;
    }
    bool first_rests = is_at_rest(i);
    bool second_rests = is_at_rest(j);
    if (first_rests && second_rests) continue;
    if (is_apart(position[i], position[j], p.contact)) continue;
    Body a = load_place(i);
    Body b = load_place(j);
    if (!in_contact(gap_between(a, b, p.contact))) continue;
    if (p.contact.damping != 0.0f) {
      a = load_body(i);
      b = load_body(j);
    }
    FloatPush push = float_push_of_pair(a, b, p.contact);
    record_fault(push.fault, min(i, j));
    if (!first_rests) add_impulse(i, push.x, push.y, push.z);
    if (!second_rests) add_impulse(j, -push.x, -push.y, -push.z);
  }
}
