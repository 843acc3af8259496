#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: computes its position at this step by the method `anchored`. Before a collision step it also
// clears the results.
#include "shaders/motion/motion_state.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (p.motion.clear_results != 0u) clear_results(i);
  if (i >= p.n) return;
  Moving s = evaluate_sphere(load_anchor(i), motion_params());
  if (p.motion.whole_state != 0u) {
    store_sphere(i, s);
  } else {
    position[i] = vec4(nearest(s.x), nearest(s.y), nearest(s.z), s.radius);
  }
}
