#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: makes one step of motion with the plane. Clears the counts and totals of the last search if
// p.motion.clear_results is set.
#include "shaders/motion/motion_state.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (p.motion.clear_results != 0u) clear_results(i);
  if (i >= p.n) return;
  store_sphere(i, take_step(METHOD, load_sphere(i), p.motion));
}
