#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere in cell order: writes its contacts by sphere index.
#include "shaders/kernels.glsl"

layout(std430, binding = SLOT_SORTED) restrict readonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict readonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (k < p.n) count[sphere_index(sorted[k], k)] = sorted_count[k];
}
