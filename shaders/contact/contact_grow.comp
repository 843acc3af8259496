#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: grows it by its skin, for the search that lists near pairs. All spheres are awake afterwards.
#include "shaders/contact/contact_rest.glsl"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_GROWN) restrict buffer GrownBuffer { vec4 grown[]; };

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i == 0u) {
    fault[LEFT_SKIN] = 0xFFFFFFFFu;
    fault[STEPS_DONE] = 0u;
  }
  if (i >= p.n) return;
  vec4 sphere = position[i];
  if (is_too_far(sphere, p.contact)) record_fault(FAULT_RANGE, i);
  grown[i] = grown_sphere(sphere, p.contact);
  record_rest(i, false);
}
