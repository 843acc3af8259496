#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: one step of motion and the plane (the paper's code 1), and the results of the last step
// cleared.
#define POSITION_ACCESS
#include "buffers.glsl"
#include "motion.h"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  clear_results(i);
  if (i >= p.n) return;
  Moving next = move_paper(position[i], velocity[i], p);
  position[i] = next.position;
  velocity[i] = next.velocity;
}
