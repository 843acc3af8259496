#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere in the order of hashed cells: tests it against the later half of its neighbourhood on its own
// level and against its whole neighbourhood on every coarser level. Rows of cells may share slots, so the cell of a
// candidate is compared too. Candidate pairs are queued and decided by the whole group.
#include "shaders/collide/collide.glsl"
#include "shaders/grid/grid.glsl"

layout(local_size_x = BLOCK) in;
const uint QUEUE = BLOCK <= 256 ? BLOCK * 6 : 2048;
shared uint queue_mine[QUEUE];
shared uint queue_other[QUEUE];
shared uint queued;

void main() {
  uint lane = gl_LocalInvocationID.x;
  start_totals();
  for (uint first = group_index() * BLOCK; first < p.n; first += group_count() * BLOCK) {
    uint i = first + lane;
    if (lane == 0u) queued = 0u;
    barrier();
    vec4 mine = with_radius(position[min(i, p.n - 1u)]);
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
          uint j = own_row ? i + 1u : cell[slot];
          uint end = cell[last + 1u] + (last < slot ? p.n : 0u);
          for (; j < end; ++j) {
            uint other = j < p.n ? j : j - p.n;
            vec4 sphere = with_radius(position[other]);
            if (in_reach(mine, sphere) && stands_in_row(sphere, level, y, z, p.grid)) {
              uint at = atomicAdd(queued, 1u);
              if (at < QUEUE) {
                queue_mine[at] = i;
                queue_other[at] = other;
              } else {
                test_stored_pair(i, other);
              }
            }
          }
        }
        y = low.y;
      }
    }
    barrier();
    uint candidates = min(queued, QUEUE);
    for (uint q = lane; q < candidates; q += BLOCK) test_stored_pair(queue_mine[q], queue_other[q]);
    barrier();
  }
  finish_totals();
}
