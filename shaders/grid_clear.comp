#version 450
// SPDX-License-Identifier: MIT
// One thread per four cells: no sphere is counted yet, no tile of the scan is done, no result is found.
#include "buffers.glsl"

layout(std430, binding = SLOT_CELL) restrict writeonly buffer CellBuffer { uvec4 cell[]; };
layout(std430, binding = SLOT_SCAN) restrict writeonly buffer ScanBuffer { uint scan[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (k <= p.cell_slots / 4u) cell[k] = uvec4(0u, 0u, 0u, 0u);
  if (k <= p.scan_tiles) scan[k] = 0u;
  if (k < SUMMARY_SLOTS * SUMMARY_WORDS) summary[k] = 0u;
}
