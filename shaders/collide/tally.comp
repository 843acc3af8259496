#version 450
// SPDX-License-Identifier: MIT
// A fixed number of threads loops over the spheres: counts those with a contact.
#include "shaders/collide/collide.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint colliding = 0u;
  start_totals();
  for (uint i = group_index() * BLOCK + gl_LocalInvocationID.x; i < p.n; i += BLOCK * gl_NumWorkGroups.x)
    if (count[i] != 0u) colliding += 1u;
  if (colliding != 0u) add_to_total(SUM_COLLIDING, uint64_t(colliding));
  finish_totals();
}
