#version 450
// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres and puts each at its place in the cell order.
#define ID_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_RANK) restrict readonly buffer RankBuffer { uint rank[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict writeonly buffer SortedCountBuffer { uint sorted_count[]; };
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
    id[place[k]] = i;
    sorted_count[i] = 0u;
  }
}
