#version 450
// SPDX-License-Identifier: MIT
// One thread per place of the cell order: its contacts go to the sphere that stands there.
#include "shaders/buffers.glsl"

layout(std430, binding = SLOT_SORTED) restrict readonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict readonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint sorted_index = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (sorted_index < p.n) count[sphere_index(sorted[sorted_index], sorted_index)] = sorted_count[sorted_index];
}
