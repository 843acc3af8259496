#version 450
// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres: the results of the last collision step cleared, for a scene that did
// not move.
#include "shaders/buffers.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint first = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) clear_results(first + k * BLOCK);
}
