#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere in cell order; groups take chunks of spheres until none is left. The later half of a sphere's
// neighbourhood is five rows of cells, each a contiguous range of spheres. A thread walks through them and keeps
// whoever is in reach; then the group settles what its threads kept, a thread per pair. A thread that can keep no more
// settles at once.
#include "collide.glsl"
#include "grid.glsl"

#define KEPT_AT_MOST (BLOCK <= 256 ? 6u : 2u)

layout(local_size_x = BLOCK) in;
shared uint kept[KEPT_AT_MOST * BLOCK];   // of each thread: who is in reach
shared uint queue[KEPT_AT_MOST * BLOCK];  // of the group: where in `kept`
shared uint contacts[BLOCK];              // of each thread's sphere, found so far
shared uint queued;

// How far ahead in the table row s of a neighbourhood is.
uint slots_ahead(uint s) { return s < 2u ? s * p.cells_x : p.cells_x * p.cells_y + (s - 3u) * p.cells_x; }

// The spheres of each of a sphere's rows, begin to end; nothing where there is no such row.
struct Ranges {
  uint begin[ROWS_AHEAD], end[ROWS_AHEAD];
};
Ranges find_ranges(vec4 mine, uint i) {
  Place place = place_of(mine, p);
  float reach = reach_in_cells(mine.w, p);
  uint x = cell_below(place.x, reach);
  uint last_x = cell_above(place.x, reach, p.cells_x);
  uint y = uint(place.y);
  uint z = uint(place.z);
  bool down = cell_below(place.y, reach) != y;
  bool up = cell_above(place.y, reach, p.cells_y) != y;
  bool ahead = cell_above(place.z, reach, p.cells_z) != z;
  bool exists[ROWS_AHEAD] = bool[](i < p.n, up, ahead && down, ahead, ahead && up);
  Ranges ranges;
  for (uint s = 0u; s < ROWS_AHEAD; ++s) {
    uint row = dense_slot(0u, y, z, p) + slots_ahead(s);
    ranges.end[s] = exists[s] && i < p.n ? cell[row + last_x + 1u] : 0u;
    ranges.begin[s] = exists[s] && i < p.n ? (s == 0u ? i + 1u : cell[row + x]) : 0u;
  }
  return ranges;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  start_totals();
  for (uint first = group_index() * BLOCK; first < p.n; first += group_count() * BLOCK) {
    uint i = first + lane;
    vec4 mine = position[min(i, p.n - 1u)];
    Ranges ranges = find_ranges(mine, i);
    contacts[lane] = 0u;
    if (lane == 0u) queued = 0u;
    barrier();
    uint reached = 0u;
    for (uint s = 0u; s < ROWS_AHEAD; ++s) {
      for (uint j = ranges.begin[s]; j < ranges.end[s]; ++j) {
        if (in_reach(mine, position[j])) {
          if (reached < KEPT_AT_MOST) {
            kept[reached * BLOCK + lane] = j;
          } else {
            meet_once(i, j);
          }
          reached += 1u;
        }
      }
    }
    reached = min(reached, KEPT_AT_MOST);
    uint at = reached != 0u ? atomicAdd(queued, reached) : 0u;
    for (uint k = 0u; k < reached; ++k) queue[at + k] = k * BLOCK + lane;
    barrier();
    uint meetings = queued;
    for (uint q = lane; q < meetings; q += BLOCK) {
      uint a = queue[q] % BLOCK;
      uint j = kept[queue[q]];
      if (meets(first + a, position[first + a], j, position[j])) {
        atomicAdd(contacts[a], 1u);
        if (j - first < BLOCK) {
          atomicAdd(contacts[j - first], 1u);
        } else {
          atomicAdd(count[j], 1u);
        }
      }
    }
    barrier();
    if (contacts[lane] != 0u) atomicAdd(count[i], contacts[lane]);
  }
  finish_totals();
}
