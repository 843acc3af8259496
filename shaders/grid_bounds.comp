#version 450
// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres that stand in cell order: it writes where the cells begin that lie
// between the sphere's predecessor and it, and clears the results. A sphere out of order, or behind too many empty
// cells, is reported.
#define CELL_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_SCAN) restrict writeonly buffer ScanBuffer { uint scan[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint start = group_index() * BLOCK * SPHERES_PER_SORTER + gl_LocalInvocationID.x;
  uint first[SPHERES_PER_SORTER];
  uint last[SPHERES_PER_SORTER];
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = min(start + k * BLOCK, p.n);
    first[k] = i == 0u ? 0u : slot_of(position[i - 1u], p) + 1u;
    last[k] = i == p.n ? p.cell_slots : slot_of(position[i], p);
  }
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) {
    uint i = start + k * BLOCK;
    clear_results(i);
    bool in_order = i <= p.n && last[k] + 1u >= first[k] && last[k] + 1u - first[k] <= EMPTY_CELLS_AT_MOST;
    if (i <= p.n && !in_order) scan[0] = 1u;
    for (uint c = first[k]; in_order && c <= last[k]; ++c) cell[c] = i;
  }
}
