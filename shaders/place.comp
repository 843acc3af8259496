#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: where the method `anchored` has it at this step, and the results of the last step cleared.
#include "motion_state.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  clear_results(i);
  if (i >= p.n) return;
  Moving s = place_sphere(load_anchor(i), p);
  if (p.whole_state != 0u) {
    store_sphere(i, s);
  } else {
    position[i] = vec4(nearest(s.x), nearest(s.y), nearest(s.z), s.radius);
  }
}
