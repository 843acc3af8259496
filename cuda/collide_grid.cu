// SPDX-License-Identifier: MIT
// One thread per sphere in cell order; groups take chunks of spheres until none is left. The later half of a sphere's
// neighbourhood is five rows of cells, each a contiguous range of spheres. A thread walks through them and keeps
// whoever is in reach; then the group settles what its threads kept, a thread per pair. A thread that can keep no more
// settles at once.
#include "cell.h"
#include "collide.cuh"

namespace spherepair {

// How far ahead in the table row s of a neighbourhood is.
__device__ inline uint slots_ahead(Params p, uint s) {
  return s < 2u ? s * p.cells_x : p.cells_x * p.cells_y + (s - 3u) * p.cells_x;
}

// The spheres of each of a sphere's rows, begin to end; nothing where there is no such row.
struct Ranges {
  uint begin[ROWS_AHEAD], end[ROWS_AHEAD];
};
__device__ inline Ranges find_ranges(Params p, const World& w, vec4 mine, uint i) {
  Place place = place_of(mine, p);
  float reach = reach_in_cells(mine.w, p);
  uint x = cell_below(place.x, reach);
  uint last_x = cell_above(place.x, reach, p.cells_x);
  uint y = uint(place.y);
  uint z = uint(place.z);
  bool down = cell_below(place.y, reach) != y;
  bool up = cell_above(place.y, reach, p.cells_y) != y;
  bool ahead = cell_above(place.z, reach, p.cells_z) != z;
  bool exists[ROWS_AHEAD] = {i < p.n, up, ahead && down, ahead, ahead && up};
  Ranges ranges;
#pragma unroll
  for (uint s = 0u; s < ROWS_AHEAD; ++s) {
    uint row = dense_slot(0u, y, z, p) + slots_ahead(p, s);
    ranges.end[s] = exists[s] && i < p.n ? w.cell[row + last_x + 1u] : 0u;
    ranges.begin[s] = exists[s] && i < p.n ? (s == 0u ? i + 1u : w.cell[row + x]) : 0u;
  }
  return ranges;
}

template <int BLOCK, bool EQUAL_RADII>
__global__ void __launch_bounds__(BLOCK) collide_grid(Params p, World w) {
  constexpr uint KEPT_AT_MOST = BLOCK <= 256 ? 6u : 2u;
  __shared__ uint kept[KEPT_AT_MOST * BLOCK];   // of each thread: who is in reach
  __shared__ uint queue[KEPT_AT_MOST * BLOCK];  // of the group: where in `kept`
  __shared__ uint contacts[BLOCK];              // of each thread's sphere, found so far
  __shared__ uint queued;
  __shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];
  Collider<EQUAL_RADII> collider(p, w, total);
  uint lane = threadIdx.x;
  collider.start_totals();
  for (uint first = group_index(p) * BLOCK; first < p.n; first += group_count() * BLOCK) {
    uint i = first + lane;
    vec4 mine = w.position[min(i, p.n - 1u)];
    Ranges ranges = find_ranges(p, w, mine, i);
    contacts[lane] = 0u;
    if (lane == 0u) queued = 0u;
    __syncthreads();
    uint reached = 0u;
#pragma unroll
    for (uint s = 0u; s < ROWS_AHEAD; ++s) {
#pragma unroll 1
      for (uint j = ranges.begin[s]; j < ranges.end[s]; ++j) {
        if (collider.in_reach(mine, w.position[j])) {
          if (reached < KEPT_AT_MOST) {
            kept[reached * BLOCK + lane] = j;
          } else {
            collider.meet_once(i, j);
          }
          reached += 1u;
        }
      }
    }
    reached = min(reached, KEPT_AT_MOST);
    uint at = reached != 0u ? atomicAdd(&queued, reached) : 0u;
#pragma unroll 1
    for (uint k = 0u; k < reached; ++k) queue[at + k] = k * BLOCK + lane;
    __syncthreads();
    uint meetings = queued;
#pragma unroll 1
    for (uint q = lane; q < meetings; q += BLOCK) {
      uint a = queue[q] % BLOCK;
      uint j = kept[queue[q]];
      if (collider.meets(first + a, w.position[first + a], j, w.position[j])) {
        atomicAdd(&contacts[a], 1u);
        if (j - first < BLOCK) {
          atomicAdd(&contacts[j - first], 1u);
        } else {
          atomicAdd(&w.count[j], 1u);
        }
      }
    }
    __syncthreads();
    if (contacts[lane] != 0u) atomicAdd(&w.count[i], contacts[lane]);
  }
  collider.finish_totals();
}

Entry collide_grid_kernel(uint block, bool equal_radii) {
  return pick_kernel(block, equal_radii,
                     [](auto size, auto equal) { return reinterpret_cast<Entry>(&collide_grid<size(), equal()>); });
}

}  // namespace spherepair
