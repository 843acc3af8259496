// SPDX-License-Identifier: MIT
// Counts become starts, in one pass (decoupled look-back, Merrill and Garland 2016): a group takes the next tile of
// cells, adds it up, and learns the sum of all tiles before it from what their groups have published.
#include "kernels.cuh"

namespace spherepair {

__device__ uvec4 operator+(uvec4 a, uvec4 b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }

// The sum of all tiles before this one: every lane waits for one of the nearest tiles, and those up to the nearest
// that knows the sum of all before it are added.
__device__ uint sum_before(uint tile, volatile uint* scan, uint* nearest, uint* gathered) {
  uint lane = threadIdx.x;
  uint sum = 0u;
  for (uint end = tile; end > 0u; end -= SCAN_BLOCK) {
    if (lane == 0u) {
      *nearest = SCAN_BLOCK;
      *gathered = 0u;
    }
    __syncthreads();
    uint state = SCAN_INCLUSIVE;
    if (lane < end) {
      do state = scan[end - lane];
      while (state == 0u);
    }
    if ((state & SCAN_INCLUSIVE) != 0u) atomicMin(nearest, lane);
    __syncthreads();
    uint last = *nearest;
    if (lane <= last) atomicAdd(gathered, state & (SCAN_PARTIAL - 1u));
    __syncthreads();
    sum += *gathered;
    if (last < SCAN_BLOCK) break;
    __syncthreads();
  }
  return sum;
}

__global__ void __launch_bounds__(SCAN_BLOCK) grid_scan(Params p, World w) {
  __shared__ uvec4 sums[SCAN_BLOCK];
  __shared__ uint this_tile, nearest, gathered;
  uvec4* cell = reinterpret_cast<uvec4*>(w.cell);
  volatile uint* scan = w.scan;
  uint lane = threadIdx.x;
  if (lane == 0u) this_tile = atomicAdd(&w.scan[0], 1u);
  __syncthreads();
  uint tile = this_tile;
  uint first = tile * SCAN_BLOCK * SCAN_VECTORS + lane;
  uvec4 counts[SCAN_VECTORS];
  for (uint v = 0u; v < SCAN_VECTORS; ++v) counts[v] = cell[first + v * SCAN_BLOCK];
  uvec4 own = {
      counts[0].x + counts[0].y + counts[0].z + counts[0].w, counts[1].x + counts[1].y + counts[1].z + counts[1].w,
      counts[2].x + counts[2].y + counts[2].z + counts[2].w, counts[3].x + counts[3].y + counts[3].z + counts[3].w};
  uvec4 upto = own;
  for (uint step = 1u; step < SCAN_BLOCK; step *= 2u) {
    sums[lane] = upto;
    __syncthreads();
    if (lane >= step) upto = upto + sums[lane - step];
    __syncthreads();
  }
  sums[lane] = upto;
  __syncthreads();
  uvec4 total = sums[SCAN_BLOCK - 1u];
  uint tile_sum = total.x + total.y + total.z + total.w;
  if (lane == 0u) scan[1u + tile] = (tile == 0u ? SCAN_INCLUSIVE : SCAN_PARTIAL) | tile_sum;
  uint before = sum_before(tile, scan, &nearest, &gathered);
  if (lane == 0u) scan[1u + tile] = SCAN_INCLUSIVE | (before + tile_sum);
  uint start[SCAN_VECTORS] = {before + upto.x - own.x, before + total.x + upto.y - own.y,
                              before + total.x + total.y + upto.z - own.z,
                              before + total.x + total.y + total.z + upto.w - own.w};
  for (uint v = 0u; v < SCAN_VECTORS; ++v) {
    uint x = start[v];
    uint y = x + counts[v].x;
    uint z = y + counts[v].y;
    cell[first + v * SCAN_BLOCK] = uvec4{x, y, z, z + counts[v].z};
  }
}

Entry grid_scan_kernel() { return reinterpret_cast<Entry>(&grid_scan); }

}  // namespace spherepair
