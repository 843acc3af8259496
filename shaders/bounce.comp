#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: one step of the method `anchored`, which touches only the spheres that may meet the plane.
#include "motion_state.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= p.n || p.steps_done < due[i]) return;
  Anchor a = anchor_anew(load_anchor(i), p);
  flight[i] = a.speed;
  flight[p.n + i] = a.age;
  since[i] = a.since;
  due[i] = next_due(a, p);
}
