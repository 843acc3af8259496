#version 450
// SPDX-License-Identifier: MIT
// Each thread takes four spheres that stand in cell order: it writes where the cells begin that lie between a sphere's
// predecessor and it, and clears a result. A sphere out of order, or behind too many empty cells, is reported.
#define CELL_ACCESS
#include "grid.glsl"

layout(std430, binding = SLOT_SCAN) restrict writeonly buffer ScanBuffer { uint tile_sum[]; };
layout(local_size_x = BLOCK) in;

// The sphere's slot; behind the last sphere, the end of the table.
uint slot_at(uint i) {
  uint slot = slot_of(position[min(i, p.n - 1u)], p);
  return i < p.n ? slot : p.cell_slots;
}

// The slot behind that of the sphere before this one.
uint slot_behind(uint i) { return i == 0u ? 0u : slot_at(i - 1u) + 1u; }

// The cells from first to last begin with sphere i.
void begin_cells(uint first, uint last, uint i) {
  bool in_order = last + 1u >= first && last + 1u - first <= EMPTY_CELLS_AT_MOST;
  if (!in_order) tile_sum[0] = 1u;
  for (uint c = first; in_order && c <= last; ++c) cell[c] = i;
}

void main() {
  uint i = group_index() * BLOCK * 4u + gl_LocalInvocationID.x;
  uint j = i + BLOCK;
  uint k = j + BLOCK;
  uint l = k + BLOCK;
  uint first_i = slot_behind(i);
  uint first_j = slot_behind(j);
  uint first_k = slot_behind(k);
  uint first_l = slot_behind(l);
  uint last_i = slot_at(i);
  uint last_j = slot_at(j);
  uint last_k = slot_at(k);
  uint last_l = slot_at(l);
  begin_cells(first_i, last_i, i);
  begin_cells(first_j, last_j, j);
  begin_cells(first_k, last_k, k);
  begin_cells(first_l, last_l, l);
  clear_results(i);
  clear_results(j);
  clear_results(k);
  clear_results(l);
}
