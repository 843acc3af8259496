// SPDX-License-Identifier: MIT
// One thread per sphere in cell order; groups take chunks of spheres until none is left. The later half of a sphere's
// neighbourhood is five rows of cells, each a contiguous range of spheres. A thread walks through all of them in one
// loop, four spheres at a time, and marks in a word whoever is in reach; then it queues them, and its team settles the
// queue, a thread per pair, in full rounds: the rest waits for the next chunk. Where a word or the queue is full, the
// team walks on after that. What the filter leaves undecided is decided at the group's end, in float64; only what that
// leaves, or has no room, is deferred.
#include "common/shared/cell.h"
#include "common/shared/exact.h"
#include "cuda/collide/collide.cuh"
#include "cuda/collide/team.cuh"

namespace spherepair {

// The k-th sphere of a walk is sphere k + shift in the first row with k < bound.
struct Row {
  uint bound, shift;
};
__device__ inline Row row_after(Row last, uint begin, uint end) {
  return Row{last.bound + end - begin, begin - last.bound};
}
__device__ inline Row row_at(Params p, const KernelBuffers& w, Row last, bool exists, uint slot, uint x, uint last_x) {
  return row_after(last, exists ? w.cell[slot + x] : 0u, exists ? w.cell[slot + last_x + 1u] : 0u);
}

// The rows of the neighbourhood: the rest of the sphere's own, the one above it, and three of the layer ahead.
struct Rows {
  Row own, above, ahead_below, ahead, ahead_above;
};
__device__ inline Rows find_rows(Params p, const KernelBuffers& w, vec4 mine, uint i, bool exists) {
  GridPosition sorted_index = grid_position(mine, p);
  float reach = reach_in_cells(mine.w, p);
  uint x = cell_below(sorted_index.x, reach);
  uint last_x = cell_above(sorted_index.x, reach, p.cells_x);
  uint y = uint(sorted_index.y);
  uint z = uint(sorted_index.z);
  bool below = cell_below(sorted_index.y, reach) != y;
  bool above = cell_above(sorted_index.y, reach, p.cells_y) != y && exists;
  bool ahead = cell_above(sorted_index.z, reach, p.cells_z) != z && exists;
  uint slot = dense_slot(0u, y, z, p);
  uint next = slot + p.cells_x * p.cells_y;
  Rows rows;
  rows.own = row_after(Row{0u, 0u}, exists ? i + 1u : 0u, exists ? w.cell[slot + last_x + 1u] : 0u);
  rows.above = row_at(p, w, rows.own, above, slot + p.cells_x, x, last_x);
  rows.ahead_below = row_at(p, w, rows.above, ahead && below, next - p.cells_x, x, last_x);
  rows.ahead = row_at(p, w, rows.ahead_below, ahead, next, x, last_x);
  rows.ahead_above = row_at(p, w, rows.ahead, ahead && above, next + p.cells_x, x, last_x);
  return rows;
}

__device__ inline uint walked(const Rows& rows, uint k) {
  uint shift = rows.ahead_above.shift;
  shift = k < rows.ahead.bound ? rows.ahead.shift : shift;
  shift = k < rows.ahead_below.bound ? rows.ahead_below.shift : shift;
  shift = k < rows.above.bound ? rows.above.shift : shift;
  shift = k < rows.own.bound ? rows.own.shift : shift;
  return k + shift;
}

// Whether the k-th sphere of the walk is in reach. Behind the last sphere of all, a guard may be read.
template <bool EQUAL_RADII, bool LISTED>
__device__ bool near(const Collider<EQUAL_RADII, LISTED>& collider, vec4 mine, const Rows& rows, uint k) {
  return collider.in_reach(mine, collider.w.position[walked(rows, k)]);
}

// Marks who is in reach among 32 spheres of the walk.
template <bool EQUAL_RADII, bool LISTED>
__device__ uint walk(const Collider<EQUAL_RADII, LISTED>& collider, vec4 mine, const Rows& rows, uint first) {
  uint marked = 0u;
  uint end = min(rows.ahead_above.bound, first + 32u);
#pragma unroll 1
  for (uint k = first; k < end; k += 4u) {
    uint four = uint(near(collider, mine, rows, k)) | uint(near(collider, mine, rows, k + 1u)) << 1 |
                uint(near(collider, mine, rows, k + 2u)) << 2 | uint(near(collider, mine, rows, k + 3u)) << 3;
    marked |= four << (k - first);
  }
  return end - first < 32u ? marked & ((1u << (end - first)) - 1u) : marked;
}

constexpr uint QUEUE_ROOM = 3u * TEAM;
constexpr uint UNDECIDED_ROOM = 16u;

struct Undecided {
  uvec2 pair[UNDECIDED_ROOM];  // the group's first pairs that the filter leaves so
  uint pairs;                  // and all of them
};
template <bool EQUAL_RADII, bool LISTED>
__device__ void leave_undecided(Collider<EQUAL_RADII, LISTED>& collider, Undecided& undecided, uint i, uint j) {
  uint k = atomicAdd(&undecided.pairs, 1u);
  if (k < UNDECIDED_ROOM) {
    undecided.pair[k] = uvec2{i, j};
  } else {
    collider.defer(i, j);
  }
}

// A thread for each pair that there was room for.
template <bool EQUAL_RADII, bool LISTED>
__device__ void decide_undecided(Collider<EQUAL_RADII, LISTED>& collider, const Undecided& undecided) {
  const KernelBuffers& w = collider.w;
  uint row = (group_index(collider.p) % SUMMARY_SLOTS) * SUMMARY_WORDS;
  uint lane = threadIdx.x;
  if (lane == 0u) atomicAdd(&w.summary[row + SUM_UNDECIDED], undecided.pairs);
  if (lane >= min(undecided.pairs, UNDECIDED_ROOM)) return;
  uint i = undecided.pair[lane].x;
  uint j = undecided.pair[lane].y;
  vec4 a = with_radius(collider.p, w.position[i]);
  vec4 b = with_radius(collider.p, w.position[j]);
  uint verdict = finite_sphere(a) && finite_sphere(b) ? decide_double(a, b) : UNDECIDED;
  if (verdict == UNDECIDED) {
    collider.defer(i, j);
    return;
  }
  atomicAdd(&w.summary[row + SUM_STAGE + STAGE_DOUBLE], 1u);
  if (verdict == APART) return;
  if (!collider.totals_later())
    collider.record(collider.sphere_index(w.position[i], i), collider.sphere_index(w.position[j], j));
  collider.add_contact(i, 1u);
  collider.add_contact(j, 1u);
}

// A group's next spheres: behind these, or those of its next stretch, as far on as all groups take.
template <uint BLOCK>
__device__ uint next_chunk(const Params& p, uint first) {
  uint behind = first + BLOCK;
  return (behind & (p.columns_per_group - 1u)) != 0u ? behind : behind + (group_count() - 1u) * p.columns_per_group;
}

// On a multiprocessor, whose registers are then shared by so many threads.
constexpr int groups_at_work(int block) { return block < 64 ? 32 : 1280 / block; }

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK, groups_at_work(BLOCK)) collide_grid(Params p, KernelBuffers w) {
  constexpr uint TEAMS = BLOCK / TEAM;
  __shared__ uvec2 queue[TEAMS * QUEUE_ROOM];  // of each team: two spheres that may meet
  __shared__ uint queued[TEAMS];
  __shared__ uint unfinished[TEAMS];
  __shared__ Undecided undecided;
  __shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];
  Collider<EQUAL_RADII, LISTED> collider(p, w, total);
  uint lane = team_lane();
  uint team = team_index();
  uint room = team * QUEUE_ROOM;
  if (lane == 0u) queued[team] = unfinished[team] = 0u;
  if (threadIdx.x == 0u) undecided.pairs = 0u;
  grid_dependency_sync();
  trigger_dependent_launch();
  collider.start_totals();
  uint end = p.n;  // GLSL may have a part of them only: sorted_begin()
  for (uint first = group_index(p) * p.columns_per_group; first < end;) {
    uint i = first + team * TEAM + lane;
    first = next_chunk<BLOCK>(p, first);
    vec4 mine = w.position[min(i, p.n - 1u)];
    if (EQUAL_RADII) mine.w = p.radius;
    Rows rows = find_rows(p, w, mine, i, i < end);
    uint marked = 0u;
    uint next = 0u;
    uint base = 0u;
    bool again = true;
    while (again) {
      if (marked == 0u && next < rows.ahead_above.bound) {
        base = next;
        next = base + 32u;
        marked = walk(collider, mine, rows, base);
      }
      uint at = marked != 0u ? atomicAdd(&queued[team], uint(__popc(marked))) : 0u;
#pragma unroll 1
      for (; marked != 0u && at < QUEUE_ROOM; ++at) {
        queue[room + at] = uvec2{i, walked(rows, base + uint(__ffs(int(marked))) - 1u)};
        marked &= marked - 1u;
      }
      if (marked != 0u || next < rows.ahead_above.bound) unfinished[team] = 1u;
      team_barrier();
      again = unfinished[team] != 0u;
      uint held = min(queued[team], QUEUE_ROOM);
      uint left = first < end || again ? held % TEAM : 0u;
#pragma unroll 1
      for (uint q = left + lane; q < held; q += TEAM) {
        uint a = queue[room + q].x;
        uint b = queue[room + q].y;
        uint verdict = collider.test_pair(a, w.position[a], b, w.position[b]);
        if (verdict == COLLIDE) {
          atomicAdd(&w.count[a], 1u);
          atomicAdd(&w.count[b], 1u);
        }
        if (verdict == UNDECIDED && p.defer_undecided != 0u) leave_undecided(collider, undecided, a, b);
      }
      team_barrier();
      if (lane == 0u) queued[team] = left;
      if (lane == 0u) unfinished[team] = 0u;
      team_barrier();
    }
  }
  if (TEAMS > 1u) __syncthreads();
  if (undecided.pairs != 0u) decide_undecided(collider, undecided);
  collider.finish_totals();
}

Entry collide_grid_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_grid<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
