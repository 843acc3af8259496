// SPDX-License-Identifier: MIT
// Groups take chunks of spheres in cell order, a thread per sphere. The later half of a sphere's neighbourhood is five
// rows of cells; the same row of all spheres of a chunk is one stretch of spheres, and the stretches go through shared
// memory. Each thread marks who is in reach; then the group settles all marks, a thread per pair. A chunk beside which a
// stretch is too long for shared memory is met in global memory.
#include "cell.h"
#include "collide.cuh"

namespace spherepair {

template <int BLOCK>
struct Chunk {
  static constexpr uint ROOM = BLOCK + BLOCK / 2;  // for the spheres of a stretch
  vec4 sphere[STRETCHES * ROOM];
  uint kept[MEETINGS_PER_THREAD * BLOCK];          // of each thread: who is in reach
  uint queue[MEETINGS_PER_THREAD * BLOCK];         // of the group: pairs, thread << 16 | sphere
  uint contacts[BLOCK];                            // of each thread's sphere, found so far
  uint first_slot, last_slot;                      // of the chunk's first and last sphere
  uint first[STRETCHES], end[STRETCHES];           // spheres of each stretch
  uint too_long, queued, most_in_reach;
  uint total[TOTAL_ROWS * TOTAL_STRIDE];
};

// How far ahead in the table stretch s is.
__device__ inline uint slots_ahead(Params p, uint s) {
  return s < 2u ? s * p.cells_x : p.cells_x * p.cells_y + (s - 3u) * p.cells_x;
}

// The spheres of each of a sphere's rows, begin to end; nothing where there is no such row.
struct Ranges {
  uint begin[STRETCHES], end[STRETCHES];
};
__device__ inline Ranges find_ranges(Params p, const World& w, Place place, float reach, uint i) {
  uint x = cell_below(place.x, reach);
  uint last_x = cell_above(place.x, reach, p.cells_x);
  uint y = uint(place.y);
  uint z = uint(place.z);
  bool down = cell_below(place.y, reach) != y;
  bool up = cell_above(place.y, reach, p.cells_y) != y;
  bool ahead = cell_above(place.z, reach, p.cells_z) != z;
  bool exists[STRETCHES] = {i < p.n, up, ahead && down, ahead, ahead && up};
  Ranges ranges;
#pragma unroll
  for (uint s = 0u; s < STRETCHES; ++s) {
    uint row = dense_slot(0u, y, z, p) + slots_ahead(p, s);
    ranges.end[s] = exists[s] && i < p.n ? w.cell[row + last_x + 1u] : 0u;
    ranges.begin[s] = exists[s] && i < p.n ? (s == 0u ? i + 1u : w.cell[row + x]) : 0u;
  }
  return ranges;
}

template <int BLOCK, bool EQUAL_RADII>
__global__ void __launch_bounds__(BLOCK) collide_grid(Params p, World w) {
  constexpr uint ROOM = Chunk<BLOCK>::ROOM;
  __shared__ Chunk<BLOCK> chunk;
  Collider<EQUAL_RADII> collider(p, w, chunk.total);
  uint lane = threadIdx.x;
  collider.start_totals();
  for (uint first = group_index(p) * BLOCK; first < p.n; first += group_count() * BLOCK) {
    uint i = first + lane;
    uint last = min(first + BLOCK, p.n) - 1u;
    vec4 mine = w.position[min(i, last)];
    Place place = place_of(mine, p);
    float reach = reach_in_cells(mine.w, p);
    uint slot = dense_slot(uint(place.x), uint(place.y), uint(place.z), p);
    if (lane == 0u) chunk.first_slot = slot;
    if (i == last) chunk.last_slot = slot;
    if (lane == 0u) chunk.too_long = 0u;
    chunk.contacts[lane] = 0u;
    __syncthreads();
    Ranges ranges = find_ranges(p, w, place, reach, i);
    if (lane < STRETCHES) {
      uint begin = chunk.first_slot + slots_ahead(p, lane);
      uint end = chunk.last_slot + slots_ahead(p, lane);
      chunk.first[lane] = lane == 0u ? first : w.cell[min(begin - min(begin, 1u), p.cell_slots)];
      chunk.end[lane] = w.cell[min(end + 2u, p.cell_slots)];
      if (chunk.end[lane] - chunk.first[lane] > ROOM) chunk.too_long = 1u;
    }
    __syncthreads();
    if (chunk.too_long != 0u) {
#pragma unroll
      for (uint s = 0u; s < STRETCHES; ++s)
        for (uint j = ranges.begin[s]; j < ranges.end[s]; ++j)
          if (collider.in_reach(mine, w.position[j])) collider.meet_once(i, j);
      __syncthreads();
      continue;
    }
    vec4 sphere[STRETCHES];
#pragma unroll
    for (uint k = lane; k < ROOM; k += BLOCK) {
#pragma unroll
      for (uint s = 0u; s < STRETCHES; ++s)
        if (chunk.first[s] + k < chunk.end[s]) sphere[s] = w.position[chunk.first[s] + k];
#pragma unroll
      for (uint s = 0u; s < STRETCHES; ++s)
        if (chunk.first[s] + k < chunk.end[s]) chunk.sphere[s * ROOM + k] = sphere[s];
    }
#pragma unroll
    for (uint s = 0u; s < STRETCHES; ++s) {
      ranges.begin[s] += s * ROOM - chunk.first[s];
      ranges.end[s] += s * ROOM - chunk.first[s];
    }
    uint done = 0u;
    uint most;
    do {
      if (lane == 0u) {
        chunk.queued = 0u;
        chunk.most_in_reach = 0u;
      }
      __syncthreads();
      uint reached = 0u;
#pragma unroll
      for (uint s = 0u; s < STRETCHES; ++s) {
#pragma unroll 1
        for (uint here = ranges.begin[s]; here < ranges.end[s]; ++here) {
          if (collider.in_reach(mine, chunk.sphere[here])) {
            if (reached - done < MEETINGS_PER_THREAD) chunk.kept[(reached - done) * BLOCK + lane] = here;
            reached += 1u;
          }
        }
      }
      if (reached > done + MEETINGS_PER_THREAD) atomicMax(&chunk.most_in_reach, reached);
      uint kept = reached > done ? min(reached - done, MEETINGS_PER_THREAD) : 0u;
      uint at = kept != 0u ? atomicAdd(&chunk.queued, kept) : 0u;
#pragma unroll 1
      for (uint k = 0u; k < kept; ++k) chunk.queue[at + k] = lane << 16 | chunk.kept[k * BLOCK + lane];
      __syncthreads();
      uint queued = chunk.queued;
      most = chunk.most_in_reach;
#pragma unroll 1
      for (uint q = lane; q < queued; q += BLOCK) {
        uint a = chunk.queue[q] >> 16;
        uint here = chunk.queue[q] & 0xFFFFu;
        uint j = here % ROOM + chunk.first[here / ROOM];
        if (collider.meets(first + a, chunk.sphere[a], j, chunk.sphere[here])) {
          atomicAdd(&chunk.contacts[a], 1u);
          if (j - first < BLOCK) {
            atomicAdd(&chunk.contacts[j - first], 1u);
          } else {
            atomicAdd(&w.count[j], 1u);
          }
        }
      }
      __syncthreads();
      done += MEETINGS_PER_THREAD;
    } while (most > done);
    if (chunk.contacts[lane] != 0u) atomicAdd(&w.count[i], chunk.contacts[lane]);
  }
  collider.finish_totals();
}

Entry collide_grid_kernel(uint block, bool equal_radii) {
  return pick_kernel(block, equal_radii, [](auto size, auto equal) {
    if constexpr (size() <= 128) return reinterpret_cast<Entry>(&collide_grid<size(), equal()>);
    return Entry(nullptr);
  });
}

}  // namespace spherepair
