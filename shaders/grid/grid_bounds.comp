#version 450
// SPDX-License-Identifier: MIT
// One group per BOUNDS_TILE spheres that are in cell order: it writes where the cells between each sphere and its
// predecessor begin, through shared memory, so that writes are coalesced, and clears the spheres' results. A sphere
// that is out of order, or follows too many empty cells, is reported.
#define CELL_ACCESS
#include "shaders/grid/grid.glsl"

layout(std430, binding = SLOT_SCAN) restrict writeonly buffer ScanBuffer { uint tile_sum[]; };
layout(local_size_x = BLOCK) in;
shared uint slot[BOUNDS_TILE + 1u];  // of the sphere before the first one, then of each
shared uint begins[BOUNDS_WINDOW];   // the window of the table that is being filled
shared uint disorder;

// Returns the sphere's slot; past the last sphere, the end of the table.
uint slot_at(uint i) {
  uint own = slot_of(position[min(i, p.n - 1u)], DENSE, p.grid);
  return i < p.n ? own : p.grid.cell_slots;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * BOUNDS_TILE;
  if (lane == 0u) disorder = 0u;
  if (lane == 0u) slot[0] = first == 0u ? ~0u : slot_at(first - 1u);
  for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) slot[k + 1u] = slot_at(first + k);
  for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) clear_results(first + k);
  barrier();
  for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) {
    bool in_order = slot[k] + 1u <= slot[k + 1u] + 1u && slot[k + 1u] - slot[k] <= EMPTY_CELLS_AT_MOST;
    if (!in_order) disorder = 1u;
  }
  barrier();
  if (disorder != 0u) {
    if (lane == 0u) tile_sum[0] = 1u;
    return;
  }
  uint behind = slot[BOUNDS_TILE] + 1u;
  for (uint low = slot[0] + 1u; low < behind; low += BOUNDS_WINDOW) {
    uint high = min(low + BOUNDS_WINDOW, behind);
    for (uint k = lane; k < BOUNDS_TILE; k += BLOCK) {
      uint end = min(slot[k + 1u] + 1u, high);
      for (uint c = max(slot[k] + 1u, low); c < end; ++c) begins[c - low] = first + k;
    }
    barrier();
    for (uint c = low + lane; c < high; c += BLOCK) cell[c] = begins[c - low];
    barrier();
  }
}
