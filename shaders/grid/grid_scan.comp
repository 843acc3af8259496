#version 450
// SPDX-License-Identifier: MIT
// One group per tile of the table: turns counts into begins by an exclusive prefix sum of the tile, plus the sums of
// the tiles before it.
#include "shaders/kernels.glsl"

layout(std430, binding = SLOT_CELL) restrict buffer CellBuffer { uvec4 cell[]; };
layout(std430, binding = SLOT_SCAN) restrict readonly buffer ScanBuffer { uint tile_sum[]; };
layout(local_size_x = BLOCK) in;
shared uvec4 sums[BLOCK];
shared uint before;

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first_tile = p.sort.first_bucket / SCAN_TILE;
  uint tile = group_index();
  if (tile >= p.sort.scan_tiles) return;
  uint first = (first_tile + tile) * (SCAN_TILE / 4u) + lane;
  uvec4 counts[SCAN_VECTORS];
  for (uint v = 0u; v < SCAN_VECTORS; ++v) counts[v] = cell[first + v * BLOCK];
  uvec4 own = {
      counts[0].x + counts[0].y + counts[0].z + counts[0].w, counts[1].x + counts[1].y + counts[1].z + counts[1].w,
      counts[2].x + counts[2].y + counts[2].z + counts[2].w, counts[3].x + counts[3].y + counts[3].z + counts[3].w};
  if (lane == 0u) before = 0u;
  barrier();
  uint share = 0u;
  for (uint t = lane; t < tile; t += BLOCK) share += tile_sum[first_tile + t];
  if (share != 0u) atomicAdd(before, share);
  uvec4 upto = own;
  for (uint step = 1u; step < BLOCK; step *= 2u) {
    sums[lane] = upto;
    barrier();
    if (lane >= step) upto = upto + sums[lane - step];
    barrier();
  }
  sums[lane] = upto;
  barrier();
  uvec4 total = sums[BLOCK - 1u];
  uint start[SCAN_VECTORS] = {before + upto.x - own.x, before + total.x + upto.y - own.y,
                              before + total.x + total.y + upto.z - own.z,
                              before + total.x + total.y + total.z + upto.w - own.w};
  for (uint v = 0u; v < SCAN_VECTORS; ++v) {
    uint x = start[v];
    uint y = x + counts[v].x;
    uint z = y + counts[v].y;
    cell[first + v * BLOCK] = uvec4(x, y, z, z + counts[v].z);
  }
}
