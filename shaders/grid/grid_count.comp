#version 450
// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER spheres: counts each in its cell, one slot after the cell's own.
#define CELL_ACCESS
#include "shaders/grid/grid.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint first = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  uint slot[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    slot[k] = slot_of(position[min(first + k * BLOCK, p.n - 1u)], DENSE, p.grid);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * BLOCK < p.n) atomicAdd(cell[slot[k] + 1u], 1u);
}
