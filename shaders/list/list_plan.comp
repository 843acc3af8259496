#version 450
// SPDX-License-Identifier: MIT
// One thread per system: its cells.
#include "shaders/list/list.glsl"
#include "common/shared/list_plan.h"

layout(local_size_x = BLOCK) in;

void main() {
  uint s = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (s >= list_state[0].systems) return;
  ListSystem planned = list_planned(list_system[s], list_state[0]);
  list_system[s] = planned;
  if (spans_too_much(planned)) list_state[0].wide = 1u;
}
