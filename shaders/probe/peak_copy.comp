#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere copies 16 bytes: measures the memory bandwidth.
#include "shaders/kernels.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= p.n) return;
  velocity[i] = position[i];
}
