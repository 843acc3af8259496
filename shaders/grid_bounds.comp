#version 450
// SPDX-License-Identifier: MIT
// Each thread takes four consecutive spheres that stand in cell order: it writes where the cells begin that lie between
// a sphere's predecessor and it, and clears four results. A sphere out of order, or behind too many empty cells, is
// reported.
#define CELL_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_SCAN) restrict writeonly buffer ScanBuffer { uint scan[]; };
layout(local_size_x = BLOCK) in;

// The sphere's slot; behind the last sphere, the end of the table.
uint slot_at(uint i) {
  uint slot = slot_of(position[min(i, p.n - 1u)], p);
  return i < p.n ? slot : p.cell_slots;
}

// The cells from first to last begin with sphere i.
void begin_cells(uint first, uint last, uint i) {
  bool in_order = last + 1u >= first && last + 1u - first <= EMPTY_CELLS_AT_MOST;
  if (!in_order) scan[0] = 1u;
  for (uint c = first; in_order && c <= last; ++c) cell[c] = i;
}

void main() {
  uint start = group_index() * BLOCK * 4u + gl_LocalInvocationID.x;
  for (uint k = 0u; k < 4u; ++k) clear_results(start + k * BLOCK);
  uint i = (group_index() * BLOCK + gl_LocalInvocationID.x) * 4u;
  uint before = i == 0u ? 0u : slot_at(i - 1u) + 1u;
  uint a = slot_at(i);
  uint b = slot_at(i + 1u);
  uint c = slot_at(i + 2u);
  uint d = slot_at(i + 3u);
  begin_cells(before, a, i);
  begin_cells(a + 1u, b, i + 1u);
  begin_cells(b + 1u, c, i + 2u);
  begin_cells(c + 1u, d, i + 3u);
}
