// SPDX-License-Identifier: MIT
// One thread per sphere in cell order; each group tests chunks of spheres until none is left. The later half of a
// sphere's neighbourhood is five rows of cells, each a contiguous range of spheres. A thread tests all of them in one
// loop, four spheres at a time, and marks the candidates in a bit mask. It queues them, and its cooperating threads
// test the queue, a thread per pair, in full rounds; the remainder waits for the next chunk. When a mask or the queue
// is full, the loop resumes after the queue has been tested. Pairs that the filter leaves undecided are decided at the
// group's end, in float64; only pairs that float64 cannot decide, or for which there is no room, are deferred.
#include "common/shared/exact.h"
#include "cuda/collide/collide.cuh"
#include "cuda/collide/cooperative_group.cuh"
#include "cuda/grid/grid.cuh"

namespace spherepair {

constexpr uint QUEUE_ROOM = 3u * COOPERATING;
constexpr uint UNDECIDED_ROOM = 16u;
__shared__ uvec2 undecided[UNDECIDED_ROOM];  // the group's first pairs that the filter leaves undecided
__shared__ uint undecided_pairs;             // how many there are in all

// The k-th sphere of a neighbourhood is sphere k + shift in the first row with k < bound.
struct Row {
  uint bound, shift;
};
__device__ inline Row row_after(Row last, uint begin, uint end) {
  return Row{last.bound + end - begin, begin - last.bound};
}
__device__ inline Row row_at(const KernelBuffers& buf, Row last, bool exists, uint slot, uint x, uint last_x) {
  return row_after(last, exists ? begin_at(buf, slot + x) : 0u, exists ? begin_at(buf, slot + last_x + 1u) : 0u);
}

// The rows of the neighbourhood: the rest of the sphere's own, the one above it, and three of the next layer.
struct Rows {
  Row own, above, ahead_below, ahead, ahead_above;
};
__device__ inline Rows find_rows(const Params& p, const KernelBuffers& buf, vec4 mine, uint i, bool exists) {
  GridPosition at = grid_position(mine, p.grid);
  float reach = reach_in_cells(mine.w, p.grid);
  uint x = cell_below(at.x, reach);
  uint last_x = cell_above(at.x, reach, p.grid.cells_x);
  uint y = uint(at.y);
  uint z = uint(at.z);
  bool below = cell_below(at.y, reach) != y;
  bool above = cell_above(at.y, reach, p.grid.cells_y) != y && exists;
  bool ahead = cell_above(at.z, reach, p.grid.cells_z) != z && exists;
  uint slot = dense_slot(0u, y, z, p.grid) - table_begin();
  uint next = slot + p.grid.cells_x * p.grid.cells_y;
  Rows rows;
  rows.own = row_after(Row{0u, 0u}, exists ? i + 1u : 0u, exists ? begin_at(buf, slot + last_x + 1u) : 0u);
  rows.above = row_at(buf, rows.own, above, slot + p.grid.cells_x, x, last_x);
  rows.ahead_below = row_at(buf, rows.above, ahead && below, next - p.grid.cells_x, x, last_x);
  rows.ahead = row_at(buf, rows.ahead_below, ahead, next, x, last_x);
  rows.ahead_above = row_at(buf, rows.ahead, ahead && above, next + p.grid.cells_x, x, last_x);
  return rows;
}

__device__ inline uint neighbour_index(const Rows& rows, uint k) {
  uint shift = rows.ahead_above.shift;
  shift = k < rows.ahead.bound ? rows.ahead.shift : shift;
  shift = k < rows.ahead_below.bound ? rows.ahead_below.shift : shift;
  shift = k < rows.above.bound ? rows.above.shift : shift;
  shift = k < rows.own.bound ? rows.own.shift : shift;
  return k + shift;
}

// Whether the k-th sphere of the neighbourhood is a candidate. Past the last sphere a guard may be read.
template <bool EQUAL_RADII, bool LISTED>
__device__ bool is_candidate(const Collider<EQUAL_RADII, LISTED, true>& collider, vec4 mine, const Rows& rows, uint k) {
  return collider.in_reach(mine, collider.buf.position[neighbour_index(rows, k)]);
}

// Returns the candidates among 32 spheres of the neighbourhood, as a bit mask.
template <bool EQUAL_RADII, bool LISTED>
__device__ uint mark_candidates(const Collider<EQUAL_RADII, LISTED, true>& collider, vec4 mine, const Rows& rows,
                                uint first) {
  uint marked = 0u;
  uint end = min(rows.ahead_above.bound, first + 32u);
  for (uint k = first; k < end; k += 4u) {
    uint four = uint(is_candidate(collider, mine, rows, k)) | uint(is_candidate(collider, mine, rows, k + 1u)) << 1 |
                uint(is_candidate(collider, mine, rows, k + 2u)) << 2 |
                uint(is_candidate(collider, mine, rows, k + 3u)) << 3;
    marked |= four << (k - first);
  }
  return end - first < 32u ? marked & ((1u << (end - first)) - 1u) : marked;
}

template <bool EQUAL_RADII, bool LISTED>
__device__ void queue_undecided(Collider<EQUAL_RADII, LISTED, true>& collider, uint i, uint j) {
  uint k = atomicAdd(&undecided_pairs, 1u);
  if (k < UNDECIDED_ROOM) {
    undecided[k] = uvec2{i, j};
  } else {
    collider.defer(i, j);
  }
}

// Decides the queued undecided pairs, one thread a pair.
template <bool EQUAL_RADII, bool LISTED>
__device__ void decide_undecided(const Params& p, const KernelBuffers& buf,
                                 Collider<EQUAL_RADII, LISTED, true>& collider) {
  uint row = (group_index(p) % SUMMARY_SLOTS) * SUMMARY_WORDS;
  uint lane = threadIdx.x;
  if (lane == 0u) atomicAdd(&buf.summary[row + SUM_UNDECIDED], undecided_pairs);
  if (lane >= min(undecided_pairs, UNDECIDED_ROOM)) return;
  uint i = undecided[lane].x;
  uint j = undecided[lane].y;
  vec4 a = with_radius(p, buf.position[i]);
  vec4 b = with_radius(p, buf.position[j]);
  uint verdict = finite_sphere(a) && finite_sphere(b) ? decide_double(a, b) : UNDECIDED;
  if (verdict == UNDECIDED) {
    collider.defer(i, j);
    return;
  }
  atomicAdd(&buf.summary[row + SUM_STAGE + STAGE_DOUBLE], 1u);
  if (verdict == APART) return;
  collider.record(sphere_index(p, buf, buf.position[i], i), sphere_index(p, buf, buf.position[j], j));
  collider.add_contact(i, 1u);
  collider.add_contact(j, 1u);
}

// Returns where the group's next spheres begin: in the rest of its chunk, else after one chunk of every other group.
template <uint BLOCK>
__device__ uint next_chunk(const Params& p, uint first) {
  uint behind = first + BLOCK;
  return (behind & (p.search.chunk - 1u)) != 0u ? behind : behind + (group_count() - 1u) * p.search.chunk;
}

// CUDA only: the resident groups of a multiprocessor, for which the compiler limits registers
constexpr int resident_groups(int block) { return block < 64 ? 32 : 1280 / block; }

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK, resident_groups(BLOCK)) collide_grid(Params p, KernelBuffers buf) {
  constexpr uint QUEUES = BLOCK / COOPERATING;
  __shared__ uvec2 queue[QUEUES * QUEUE_ROOM];  // candidate pairs of each set of cooperating threads
  __shared__ uint queued[QUEUES];
  __shared__ uint unfinished[QUEUES];
  Collider<EQUAL_RADII, LISTED, true> collider(p, buf);
  uint lane = cooperating_lane();
  uint own = cooperating_index();
  if (lane == 0u) queued[own] = unfinished[own] = 0u;
  if (threadIdx.x == 0u) undecided_pairs = 0u;
  grid_dependency_sync();      // CUDA only: the sort has written what follows reads
  trigger_dependent_launch();  // CUDA only: the next step's split_tiles writes nothing that this kernel reads
  collider.start_totals();
  uint end = sorted_end(p) - sorted_begin();
  for (uint first = group_index(p) * p.search.chunk; first < end;) {
    uint k = first + own * COOPERATING + lane;
    uint i = sorted_begin() + k;
    first = next_chunk<BLOCK>(p, first);
    vec4 mine = buf.position[min(i, p.n - 1u)];
    if (EQUAL_RADII) mine.w = p.radius;
    Rows rows = find_rows(p, buf, mine, i, k < end);
    uint marked = 0u;
    uint next = 0u;
    uint base = 0u;
    bool again = true;
    while (again) {
      if (marked == 0u && next < rows.ahead_above.bound) {
        base = next;
        next = base + 32u;
        marked = mark_candidates(collider, mine, rows, base);
      }
      uint at = marked != 0u ? atomicAdd(&queued[own], count_bits(marked)) : 0u;
      for (; marked != 0u && at < QUEUE_ROOM; ++at) {
        queue[own * QUEUE_ROOM + at] = uvec2{i, neighbour_index(rows, base + lowest_bit(marked))};
        marked &= marked - 1u;
      }
      if (marked != 0u || next < rows.ahead_above.bound) unfinished[own] = 1u;
      cooperating_barrier();
      again = unfinished[own] != 0u;
      uint held = min(queued[own], QUEUE_ROOM);
      uint left = first < end || again ? held % COOPERATING : 0u;
      for (uint q = left + lane; q < held; q += COOPERATING) {
        uint a = queue[own * QUEUE_ROOM + q].x;
        uint b = queue[own * QUEUE_ROOM + q].y;
        uint verdict = collider.test_pair(a, buf.position[a], b, buf.position[b]);
        if (verdict == COLLIDE) {
          collider.add_contact(a, 1u);
          collider.add_contact(b, 1u);
        }
        if (verdict == UNDECIDED && p.search.defer_undecided != 0u) queue_undecided(collider, a, b);
      }
      cooperating_barrier();
      if (lane == 0u) queued[own] = left;
      if (lane == 0u) unfinished[own] = 0u;
      cooperating_barrier();
    }
  }
  if (QUEUES > 1u) __syncthreads();
  if (undecided_pairs != 0u) decide_undecided(p, buf, collider);
  collider.finish_totals();
}

Entry collide_grid_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_grid<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
