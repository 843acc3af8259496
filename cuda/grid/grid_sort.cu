// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket of more spheres than SORT_EACH a thread is copied as it comes. Totals
// are cleared here.
#include "common/shared/cell.h"
#include "cuda/grid/group_sum.cuh"
#include "cuda/kernels.cuh"

namespace spherepair {
namespace {

constexpr uint HELD = SORT_EACH * SORT_BLOCK;
static_assert(HELD <= CELLS_PER_BUCKET && CELLS_PER_BUCKET <= 1u << 16);

// The spheres of a bucket: from which place on they go, and how many they are. They stand in runs; of a crowd,
// run_threads threads walk through each.
struct Bucket {
  uint begin, size, runs;
};
struct Run {
  uint begin, end;
};
template <bool FROM_TILES>
constexpr uint run_threads = FROM_TILES ? 32u : SORT_BLOCK;

// FROM_TILES: of a tile; else the only one.
template <bool FROM_TILES>
__device__ inline Run run_of(const Params& p, const KernelBuffers& w, uint bucket, uint tile) {
  if constexpr (FROM_TILES) {
    uint run = w.bucket_cursor[tile * BUCKETS_AT_MOST + bucket];
    return {tile * SPLIT_TILE + begin_in_tile(run), tile * SPLIT_TILE + end_in_tile(run)};
  } else {
    uint begin = bucket == 0u ? 0u : w.bucket_cursor[p.first_bucket + bucket - 1u];
    return {begin, w.bucket_cursor[p.first_bucket + bucket]};
  }
}

// FROM_TILES: a thread finds the run of each tile.
template <bool FROM_TILES>
__device__ inline Bucket find_bucket(const Params& p, const KernelBuffers& w, uint bucket, uint* sorted_index) {
  uint lane = threadIdx.x;
  if constexpr (FROM_TILES) {
    __shared__ uint bucket_begin, bucket_size;
    uint tiles = (p.n + SPLIT_TILE - 1u) / SPLIT_TILE;
    uint tile = min(lane, tiles - 1u) * SPLIT_TILE;
    Run run = run_of<true>(p, w, bucket, min(lane, tiles - 1u));
    uint begin = lane < tiles ? run.begin - tile : 0u;
    uint end = lane < tiles ? run.end - tile : 0u;
    if (lane == 0u) bucket_begin = 0u;
    uint size = sum_up_to<SORT_BLOCK>(end - begin);
    if (begin != 0u) atomicAdd(&bucket_begin, begin);
    for (uint k = begin; k < end && size - end + k < HELD; ++k) sorted_index[size - end + k] = tile + k;
    if (lane == SORT_BLOCK - 1u) bucket_size = size;
    __syncthreads();
    return {bucket_begin, bucket_size, tiles};
  } else {
    Run run = run_of<false>(p, w, bucket, 0u);
    return {run.begin, run.end - run.begin, 1u};
  }
}
// Where the k-th sphere of the bucket stands, or behind its last one that one; any sphere where it has none.
template <bool FROM_TILES>
__device__ inline uint held(Bucket b, uint k, const uint* sorted_index) {
  if (b.size == 0u) return 0u;
  return FROM_TILES ? sorted_index[min(k, b.size - 1u)] : b.begin + min(k, b.size - 1u);
}

// Sphere i of those that were split.
__device__ inline void put(const Params& p, const KernelBuffers& w, vec4 sphere, uint i, uint at) {
  w.sorted[at] = sphere;
  if ((p.indices & INDEX_IN_W) == 0u) w.id[at] = w.from_id[i];
  w.sorted_count[at] = 0u;
}

// Makes of the counts where the cells begin, in the bucket and in the table.
__device__ inline void begin_cells(const Params& p, const KernelBuffers& w, Bucket b, uint low, uint* sorted_index) {
  uint lane = threadIdx.x;
  __syncthreads();
  uint own = 0u;
  for (uint k = 0u; k < CELLS_PER_BUCKET / SORT_BLOCK; ++k)
    own += sorted_index[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k];
  uint upto = sum_up_to<SORT_BLOCK>(own) - own;
  for (uint k = 0u; k < CELLS_PER_BUCKET / SORT_BLOCK; ++k) {
    uint counted = sorted_index[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k];
    sorted_index[lane * (CELLS_PER_BUCKET / SORT_BLOCK) + k] = upto;
    upto += counted;
  }
  __syncthreads();
  for (uint k = lane; k < 1u << p.bucket_shift; k += SORT_BLOCK)
    if (low + k <= p.cell_slots) w.cell[low + k] = b.begin + sorted_index[k];
}

template <bool FROM_TILES, bool DENSE>
__device__ inline void sort_held(const Params& p, const KernelBuffers& w, Bucket b, uint low, uint* sorted_index) {
  uint lane = threadIdx.x;
  uint from[SORT_EACH];           // where the thread's spheres stand
  uint cell_and_rank[SORT_EACH];  // of each, in the bucket; the rank in the upper half
  for (uint k = 0u; k < SORT_EACH; ++k) from[k] = held<FROM_TILES>(b, lane + k * SORT_BLOCK, sorted_index);
  __syncthreads();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += SORT_BLOCK) sorted_index[c] = 0u;
  for (uint k = 0u; k < SORT_EACH; ++k) cell_and_rank[k] = slot_of(w.position[from[k]], DENSE, p) - low;
  __syncthreads();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * SORT_BLOCK < b.size) cell_and_rank[k] |= atomicAdd(&sorted_index[cell_and_rank[k]], 1u) << 16;
  begin_cells(p, w, b, low, sorted_index);
  for (uint k = 0u; k < SORT_EACH; ++k)
    cell_and_rank[k] = sorted_index[cell_and_rank[k] % CELLS_PER_BUCKET] + (cell_and_rank[k] >> 16);
  __syncthreads();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * SORT_BLOCK < b.size) sorted_index[cell_and_rank[k]] = from[k];
  __syncthreads();
  for (uint k = lane; k < b.size; k += SORT_BLOCK) put(p, w, w.position[sorted_index[k]], sorted_index[k], b.begin + k);
}

template <bool FROM_TILES, bool DENSE>
__device__ inline void sort_oversized_bucket(const Params& p, const KernelBuffers& w, Bucket b, uint low,
                                             uint* sorted_index) {
  constexpr uint RUN_THREADS = run_threads<FROM_TILES>;
  uint lane = threadIdx.x;
  __syncthreads();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += SORT_BLOCK) sorted_index[c] = 0u;
  __syncthreads();
  for (uint r = lane / RUN_THREADS; r < b.runs; r += SORT_BLOCK / RUN_THREADS) {
    Run run = run_of<FROM_TILES>(p, w, group_index(p), r);
    for (uint i = run.begin + lane % RUN_THREADS; i < run.end; i += RUN_THREADS)
      atomicAdd(&sorted_index[slot_of(w.position[i], DENSE, p) - low], 1u);
  }
  begin_cells(p, w, b, low, sorted_index);
  __syncthreads();
  for (uint r = lane / RUN_THREADS; r < b.runs; r += SORT_BLOCK / RUN_THREADS) {
    Run run = run_of<FROM_TILES>(p, w, group_index(p), r);
    for (uint i = run.begin + lane % RUN_THREADS; i < run.end; i += RUN_THREADS) {
      vec4 sphere = w.position[i];
      put(p, w, sphere, i, b.begin + atomicAdd(&sorted_index[slot_of(sphere, DENSE, p) - low], 1u));
    }
  }
}

}  // namespace

template <bool FROM_TILES, bool DENSE>
__global__ void __launch_bounds__(SORT_BLOCK, 4) grid_sort(Params p, KernelBuffers w) {
  __shared__ uint sorted_index[CELLS_PER_BUCKET];  // where the bucket's spheres stand; then, in the bucket, of the next
                                                   // sphere of each cell; then its spheres by cell
  grid_dependency_sync();
  if (group_index(p) >= p.buckets) return;
  uint low = group_index(p) << p.bucket_shift;
  for (uint k = threadIdx.x; low == 0u && k < SUMMARY_SLOTS * SUMMARY_WORDS; k += SORT_BLOCK) w.summary[k] = 0u;
  Bucket b = find_bucket<FROM_TILES>(p, w, group_index(p), sorted_index);
  if (b.size <= HELD) {
    sort_held<FROM_TILES, DENSE>(p, w, b, low, sorted_index);
  } else {
    sort_oversized_bucket<FROM_TILES, DENSE>(p, w, b, low, sorted_index);
  }
}

Entry grid_sort_kernel(uint, Variant variant) {
  if (variant.dense)
    return variant.from_tiles ? reinterpret_cast<Entry>(&grid_sort<true, true>)
                              : reinterpret_cast<Entry>(&grid_sort<false, true>);
  return variant.from_tiles ? reinterpret_cast<Entry>(&grid_sort<true, false>)
                            : reinterpret_cast<Entry>(&grid_sort<false, false>);
}

}  // namespace spherepair
