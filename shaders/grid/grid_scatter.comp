#version 450
// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER spheres: writes each to the next sorted index of its cell. The slot after a cell's
// own is the write cursor, and so, in the end, the begin of the next cell.
#define CELL_ACCESS
#define ID_ACCESS
#include "shaders/grid/grid.glsl"

layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict writeonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint first = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  vec4 sphere[SPHERES_PER_SORTER];
  uint sorted_index[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) sphere[k] = position[min(first + k * BLOCK, p.n - 1u)];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k)
    if (first + k * BLOCK < p.n) sorted_index[k] = atomicAdd(cell[slot_of(sphere[k], DENSE, p.grid) + 1u], 1u);
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = first + k * BLOCK;
    if (i < p.n) {
      if (p.sort.index_in_w != 0u) {
        sphere[k].w = bits_float(i);
      } else {
        id[sorted_index[k]] = i;
      }
      sorted[sorted_index[k]] = sphere[k];
      sorted_count[i] = 0u;
    }
  }
}
