#version 450
// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER places of the cell order: the contacts of each go to the sphere that stands there.
#include "buffers.glsl"

layout(std430, binding = SLOT_SORTED_COUNT) restrict readonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint first = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint place = first + k * BLOCK;
    if (place < p.n) count[id[place]] = sorted_count[place];
  }
}
