#version 450
// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER spheres: clears the results of the last collision step, for a scene that did not
// move.
#include "shaders/kernels.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint first = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) clear_results(first + k * BLOCK);
}
