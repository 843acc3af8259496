#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere of a sample, which is taken at equal distances from all spheres as they are numbered.
#include "shaders/buffers.glsl"

layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  sorted[k] = position[uint(uint64_t(k) * uint64_t(p.n) / uint64_t(group_count() * BLOCK))];
}
