#version 450
// SPDX-License-Identifier: MIT
// Counts become starts, in one pass (decoupled look-back, Merrill and Garland 2016): a group takes the next tile of
// cells, adds it up, and learns the sum of all tiles before it from what their groups have published.
#include "buffers.glsl"

layout(std430, binding = SLOT_CELL) restrict buffer CellBuffer { uvec4 cell[]; };
layout(std430, binding = SLOT_SCAN) coherent volatile buffer ScanBuffer { uint scan[]; };
layout(local_size_x = BLOCK) in;
shared uvec4 sums[BLOCK];
shared uint this_tile, nearest, gathered;

// The sum of all tiles before this one: every lane waits for one of the nearest tiles, and those up to the nearest
// that knows the sum of all before it are added.
uint sum_before(uint tile) {
  uint lane = gl_LocalInvocationID.x;
  uint sum = 0u;
  for (uint end = tile; end > 0u; end -= BLOCK) {
    if (lane == 0u) {
      nearest = BLOCK;
      gathered = 0u;
    }
    barrier();
    uint state = SCAN_INCLUSIVE;
    if (lane < end) {
      do state = scan[end - lane];
      while (state == 0u);
    }
    if ((state & SCAN_INCLUSIVE) != 0u) atomicMin(nearest, lane);
    barrier();
    uint last = nearest;
    if (lane <= last) atomicAdd(gathered, state & (SCAN_PARTIAL - 1u));
    barrier();
    sum += gathered;
    if (last < BLOCK) break;
    barrier();
  }
  return sum;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (lane == 0u) this_tile = atomicAdd(scan[0], 1u);
  barrier();
  uint tile = this_tile;
  uint first = tile * BLOCK * SCAN_VECTORS + lane;
  uvec4 counts[SCAN_VECTORS];
  for (uint v = 0u; v < SCAN_VECTORS; ++v) counts[v] = cell[first + v * BLOCK];
  uvec4 own = uvec4(
      counts[0].x + counts[0].y + counts[0].z + counts[0].w, counts[1].x + counts[1].y + counts[1].z + counts[1].w,
      counts[2].x + counts[2].y + counts[2].z + counts[2].w, counts[3].x + counts[3].y + counts[3].z + counts[3].w);
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
  uint tile_sum = total.x + total.y + total.z + total.w;
  if (lane == 0u) scan[1u + tile] = (tile == 0u ? SCAN_INCLUSIVE : SCAN_PARTIAL) | tile_sum;
  uint before = sum_before(tile);
  if (lane == 0u) scan[1u + tile] = SCAN_INCLUSIVE | (before + tile_sum);
  uint start[SCAN_VECTORS] =
      uint[](before + upto.x - own.x, before + total.x + upto.y - own.y, before + total.x + total.y + upto.z - own.z,
             before + total.x + total.y + total.z + upto.w - own.w);
  for (uint v = 0u; v < SCAN_VECTORS; ++v) {
    uint x = start[v];
    uint y = x + counts[v].x;
    uint z = y + counts[v].y;
    cell[first + v * BLOCK] = uvec4(x, y, z, z + counts[v].z);
  }
}
