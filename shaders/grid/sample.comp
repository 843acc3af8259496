#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere of a sample: copies it, at equal strides of the sphere index.
#include "shaders/kernels.glsl"

layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  sorted[k] = position[uint(uint64_t(k) * uint64_t(p.n) / uint64_t(group_count() * BLOCK))];
}
