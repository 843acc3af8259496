#version 450
// SPDX-License-Identifier: MIT
// Groups take chunks of spheres in cell order, a thread per sphere. The later half of a sphere's neighbourhood is five
// rows of cells; the same row of all spheres of a chunk is one stretch of spheres, and the stretches go through shared
// memory. Each thread marks who is in reach; then the group settles all marks, a thread per pair. A chunk beside which a
// stretch is too long for shared memory is met in global memory.
#include "collide.glsl"
#include "cell.h"

#define ROOM (BLOCK + BLOCK / 2)  // for the spheres of a stretch

layout(std430, binding = SLOT_CELL) restrict readonly buffer CellBuffer { uint cell[]; };
layout(local_size_x = BLOCK) in;
shared vec4 chunk_sphere[STRETCHES * ROOM];
shared uint chunk_kept[MEETINGS_PER_THREAD * BLOCK];   // of each thread: who is in reach
shared uint chunk_queue[MEETINGS_PER_THREAD * BLOCK];  // of the group: pairs, thread << 16 | sphere
shared uint chunk_contacts[BLOCK];                     // of each thread's sphere, found so far
shared uint first_slot, last_slot;                     // of the chunk's first and last sphere
shared uint chunk_first[STRETCHES], chunk_end[STRETCHES];  // spheres of each stretch
shared uint too_long, chunk_queued, most_in_reach;

// How far ahead in the table stretch s is.
uint slots_ahead(uint s) { return s < 2u ? s * p.cells_x : p.cells_x * p.cells_y + (s - 3u) * p.cells_x; }

// The spheres of each of a sphere's rows, begin to end; nothing where there is no such row.
struct Ranges {
  uint begin[STRETCHES], end[STRETCHES];
};
Ranges find_ranges(Place place, float reach, uint i) {
  uint x = cell_below(place.x, reach);
  uint last_x = cell_above(place.x, reach, p.cells_x);
  uint y = uint(place.y);
  uint z = uint(place.z);
  bool down = cell_below(place.y, reach) != y;
  bool up = cell_above(place.y, reach, p.cells_y) != y;
  bool ahead = cell_above(place.z, reach, p.cells_z) != z;
  bool exists[STRETCHES] = bool[](i < p.n, up, ahead && down, ahead, ahead && up);
  Ranges ranges;
  for (uint s = 0u; s < STRETCHES; ++s) {
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
    uint last = min(first + BLOCK, p.n) - 1u;
    vec4 mine = position[min(i, last)];
    Place place = place_of(mine, p);
    float reach = reach_in_cells(mine.w, p);
    uint slot = dense_slot(uint(place.x), uint(place.y), uint(place.z), p);
    if (lane == 0u) first_slot = slot;
    if (i == last) last_slot = slot;
    if (lane == 0u) too_long = 0u;
    chunk_contacts[lane] = 0u;
    barrier();
    Ranges ranges = find_ranges(place, reach, i);
    if (lane < STRETCHES) {
      uint begin = first_slot + slots_ahead(lane);
      uint end = last_slot + slots_ahead(lane);
      chunk_first[lane] = lane == 0u ? first : cell[min(begin - min(begin, 1u), p.cell_slots)];
      chunk_end[lane] = cell[min(end + 2u, p.cell_slots)];
      if (chunk_end[lane] - chunk_first[lane] > ROOM) too_long = 1u;
    }
    barrier();
    if (too_long != 0u) {
      for (uint s = 0u; s < STRETCHES; ++s)
        for (uint j = ranges.begin[s]; j < ranges.end[s]; ++j)
          if (in_reach(mine, position[j])) meet_once(i, j);
      barrier();
      continue;
    }
    vec4 sphere[STRETCHES];
    for (uint k = lane; k < ROOM; k += BLOCK) {
      for (uint s = 0u; s < STRETCHES; ++s)
        if (chunk_first[s] + k < chunk_end[s]) sphere[s] = position[chunk_first[s] + k];
      for (uint s = 0u; s < STRETCHES; ++s)
        if (chunk_first[s] + k < chunk_end[s]) chunk_sphere[s * ROOM + k] = sphere[s];
    }
    for (uint s = 0u; s < STRETCHES; ++s) {
      ranges.begin[s] += s * ROOM - chunk_first[s];
      ranges.end[s] += s * ROOM - chunk_first[s];
    }
    uint done = 0u;
    uint most;
    do {
      if (lane == 0u) {
        chunk_queued = 0u;
        most_in_reach = 0u;
      }
      barrier();
      uint reached = 0u;
      for (uint s = 0u; s < STRETCHES; ++s) {
        for (uint here = ranges.begin[s]; here < ranges.end[s]; ++here) {
          if (in_reach(mine, chunk_sphere[here])) {
            if (reached - done < MEETINGS_PER_THREAD) chunk_kept[(reached - done) * BLOCK + lane] = here;
            reached += 1u;
          }
        }
      }
      if (reached > done + MEETINGS_PER_THREAD) atomicMax(most_in_reach, reached);
      uint kept = reached > done ? min(reached - done, MEETINGS_PER_THREAD) : 0u;
      uint at = kept != 0u ? atomicAdd(chunk_queued, kept) : 0u;
      for (uint k = 0u; k < kept; ++k) chunk_queue[at + k] = lane << 16 | chunk_kept[k * BLOCK + lane];
      barrier();
      uint queued = chunk_queued;
      most = most_in_reach;
      for (uint q = lane; q < queued; q += BLOCK) {
        uint a = chunk_queue[q] >> 16;
        uint here = chunk_queue[q] & 0xFFFFu;
        uint j = here % ROOM + chunk_first[here / ROOM];
        if (meets(first + a, chunk_sphere[a], j, chunk_sphere[here])) {
          atomicAdd(chunk_contacts[a], 1u);
          if (j - first < BLOCK) {
            atomicAdd(chunk_contacts[j - first], 1u);
          } else {
            atomicAdd(count[j], 1u);
          }
        }
      }
      barrier();
      done += MEETINGS_PER_THREAD;
    } while (most > done);
    if (chunk_contacts[lane] != 0u) atomicAdd(count[i], chunk_contacts[lane]);
  }
  finish_totals();
}
