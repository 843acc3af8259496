#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere copies 16 bytes a word at a time: measures what loads and stores of whole vectors save.
#include "shaders/kernels.glsl"

layout(std430, binding = SLOT_POSITION) restrict readonly buffer PositionWords { uint position_word[]; };
layout(std430, binding = SLOT_VELOCITY) restrict writeonly buffer VelocityWords { uint velocity_word[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= p.n) return;
  for (uint k = 0u; k < 4u; ++k) velocity_word[4u * i + k] = position_word[4u * i + k];
}
