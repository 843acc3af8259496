#version 450
// SPDX-License-Identifier: MIT
// One thread per LIST_EACH elements: wraps each into its system's box, and adds it to the extremes of the system; the
// group adds up those of its first system.
#include "shaders/list/list_extremes.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * BLOCK * LIST_EACH + lane;
  uint elements = list_state[0].points + list_state[0].queries;
  if (lane == 0u) group_system = system_of(min(first, elements - 1u));
  if (lane < LIST_EXTREMES) extreme[lane] = 0u;
  barrier();
  Extremes own = no_extremes();
  for (uint k = 0u; k < LIST_EACH; ++k) {
    uint i = first + k * BLOCK;
    if (i < elements) own = measured(own, i, system_of(i));
  }
  add_up(own);
  barrier();
  if (lane < LIST_EXTREMES && extreme[lane] != 0u) atomicMax(list_system[group_system].extreme[lane], extreme[lane]);
}
