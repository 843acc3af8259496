#version 450
// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres and puts each at its place in the cell order.
#define ID_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_SPLIT_ID) restrict readonly buffer SplitIdBuffer { uint split_id[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint first = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  vec4 sphere[SPHERES_PER_SORTER];
  uint place[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) sphere[k] = position[min(first + k * BLOCK, p.n - 1u)];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    place[k] = cell[slot_of(sphere[k], p)] + rank[min(first + k * BLOCK, p.n - 1u)];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = first + k * BLOCK;
    if (i >= p.n) return;
    sorted[place[k]] = sphere[k];
    id[place[k]] = p.in_buckets != 0u ? split_id[i] : i;
    sorted_count[i] = 0u;
  }
}
