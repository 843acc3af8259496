#version 450
// SPDX-License-Identifier: MIT
// One group per tile of the table: sums it up, for grid_scan.
#include "shaders/kernels.glsl"

layout(std430, binding = SLOT_CELL) restrict readonly buffer CellBuffer { uvec4 cell[]; };
layout(std430, binding = SLOT_SCAN) restrict writeonly buffer ScanBuffer { uint tile_sum[]; };
layout(local_size_x = BLOCK) in;
shared uint sum;

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint tile = p.sort.first_bucket / SCAN_TILE + group_index();
  if (group_index() >= p.sort.scan_tiles) return;
  if (lane == 0u) sum = 0u;
  barrier();
  uint own = 0u;
  for (uint v = 0u; v < SCAN_VECTORS; ++v) {
    uvec4 counts = cell[tile * (SCAN_TILE / 4u) + v * BLOCK + lane];
    own += counts.x + counts.y + counts.z + counts.w;
  }
  atomicAdd(sum, own);
  barrier();
  if (lane == 0u) tile_sum[tile] = sum;
}
