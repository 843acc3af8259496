#version 450
// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres: it counts each in its cell, and the count so far is the sphere's rank.
#define CELL_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_RANK) restrict writeonly buffer RankBuffer { uint rank[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint first = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  uint slot[SPHERES_PER_SORTER];
  uint before[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) slot[k] = slot_of(position[min(first + k * BLOCK, p.n - 1u)], p);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * BLOCK < p.n) before[k] = atomicAdd(cell[slot[k]], 1u);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * BLOCK < p.n) rank[first + k * BLOCK] = before[k];
}
