#version 450
// SPDX-License-Identifier: MIT
// One thread per listed pair, in turns until none is left: what the two spheres give each other in a step. Pairs come
// from the search of these positions, in any order.
#include "shaders/contact/contact_state.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint pairs = min(summary[SUM_LISTED], p.search.pair_capacity);
  for (uint k = group_index() * BLOCK + gl_LocalInvocationID.x; k < pairs; k += group_count() * BLOCK) {
    uint i = listed[k].x;
    uint j = listed[k].y;
    Push push = push_of_pair(load_body(i), load_body(j), p.contact);
    record_fault(push.fault, i);
    add_impulse(i, push.x, push.y, push.z);
    add_impulse(j, -push.x, -push.y, -push.z);
  }
}
