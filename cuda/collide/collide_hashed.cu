// SPDX-License-Identifier: MIT
// One thread per sphere in the order of hashed cells: tests it against the later half of its neighbourhood on its own
// level and against its whole neighbourhood on every coarser level. Rows of cells may share slots, so the cell of a
// candidate is compared too. Candidate pairs are queued and decided by the whole group.
#include "cuda/collide/collide.cuh"
#include "cuda/grid/grid.cuh"

namespace spherepair {

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_hashed(Params p, KernelBuffers buf) {
  constexpr uint QUEUE = BLOCK <= 256 ? BLOCK * 6 : 2048;
  __shared__ uint queue_mine[QUEUE];
  __shared__ uint queue_other[QUEUE];
  __shared__ uint queued;
  Collider<EQUAL_RADII, LISTED, true> collider(p, buf);
  uint lane = threadIdx.x;
  collider.start_totals();
  for (uint first = group_index(p) * BLOCK; first < p.n; first += group_count() * BLOCK) {
    uint i = first + lane;
    if (lane == 0u) queued = 0u;
    __syncthreads();
    vec4 mine = with_radius(p, buf.position[min(i, p.n - 1u)]);
    uint own_level = level_of(mine.w, p.grid);
    Cell own = cell_at(mine.x, mine.y, mine.z, own_level, p.grid);
    for (uint level = i < p.n ? own_level : p.grid.top_level + 1u; level <= p.grid.top_level; ++level) {
      if ((p.grid.levels >> level & 1u) == 0u) continue;
      float reach = reach_of(mine.w, level, p.grid);
      Cell low = lowest_cell(mine, reach, level, p.grid);
      Cell high = highest_cell(mine, reach, level, p.grid);
      bool later_half = level == own_level;
      int y = later_half ? own.y : low.y;
      for (int z = later_half ? own.z : low.z; z <= high.z; ++z) {
        for (; y <= high.y; ++y) {
          uint row = row_slot(level, y, z);
          bool own_row = later_half && y == own.y && z == own.z;
          uint slot = slot_in_row(row, own_row ? own.x : low.x, p.grid);
          uint last = slot_in_row(row, high.x, p.grid);
          uint j = own_row ? i + 1u : buf.cell[slot];
          uint end = buf.cell[last + 1u] + (last < slot ? p.n : 0u);
          for (; j < end; ++j) {
            uint other = j < p.n ? j : j - p.n;
            vec4 sphere = with_radius(p, buf.position[other]);
            if (collider.in_reach(mine, sphere) && stands_in_row(sphere, level, y, z, p.grid)) {
              uint at = atomicAdd(&queued, 1u);
              if (at < QUEUE) {
                queue_mine[at] = i;
                queue_other[at] = other;
              } else {
                collider.test_stored_pair(i, other);
              }
            }
          }
        }
        y = low.y;
      }
    }
    __syncthreads();
    uint candidates = min(queued, QUEUE);
    for (uint q = lane; q < candidates; q += BLOCK) collider.test_stored_pair(queue_mine[q], queue_other[q]);
    __syncthreads();
  }
  collider.finish_totals();
}

Entry collide_hashed_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_hashed<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
