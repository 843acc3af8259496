// SPDX-License-Identifier: MIT
// One group per bucket: a counting sort of its spheres by cell. It counts them by cell, computes the prefix sum, writes
// where the cells begin, sorts the spheres' indices in shared memory and copies the spheres in that order, so that
// writes are coalesced. An oversized bucket, of more spheres than SORT_EACH a thread, is scattered directly. Totals are
// cleared here.
#include "cuda/grid/grid.cuh"
#include "cuda/grid/group_sum.cuh"

namespace spherepair {

constexpr uint BLOCK = SORT_BLOCK;
constexpr uint MOST_HELD = SORT_EACH * BLOCK;
template <bool FROM_TILES>
constexpr uint RUN_THREADS = FROM_TILES ? 32u : uint(BLOCK);  // threads that share a run of an oversized bucket
__shared__ uint
    scratch[CELLS_PER_BUCKET];  // indices of the bucket's spheres, then cursors of its cells, then sorted indices
__shared__ uint bucket_begin, bucket_size;
static_assert(MOST_HELD <= CELLS_PER_BUCKET && CELLS_PER_BUCKET <= 1u << 16);

// The spheres of a bucket: their first sorted index, their number, and the runs in which they come.
struct Bucket {
  uint begin, size, runs;
};
struct Run {
  uint begin, end;
};

// Returns the run of a tile (FROM_TILES), else the only one.
template <bool FROM_TILES>
__device__ inline Run run_of(const Params& p, const KernelBuffers& buf, uint bucket, uint tile) {
  if constexpr (FROM_TILES) {
    uint run = buf.bucket_cursor[tile * BUCKETS_AT_MOST + bucket];
    return Run{tile * SPLIT_TILE + begin_in_tile(run), tile * SPLIT_TILE + end_in_tile(run)};
  } else {
    uint begin = bucket == 0u ? 0u : buf.bucket_cursor[p.sort.first_bucket + bucket - 1u];
    return Run{begin, buf.bucket_cursor[p.sort.first_bucket + bucket]};
  }
}

// Finds the bucket's spheres. FROM_TILES: one thread per tile lists the spheres of its run in `scratch`.
template <bool FROM_TILES>
__device__ inline Bucket find_bucket(const Params& p, const KernelBuffers& buf, uint bucket) {
  uint lane = threadIdx.x;
  if constexpr (FROM_TILES) {
    uint tiles = (p.n + SPLIT_TILE - 1u) / SPLIT_TILE;
    uint tile = min(lane, tiles - 1u) * SPLIT_TILE;
    Run run = run_of<FROM_TILES>(p, buf, bucket, min(lane, tiles - 1u));
    uint begin = lane < tiles ? run.begin - tile : 0u;
    uint end = lane < tiles ? run.end - tile : 0u;
    if (lane == 0u) bucket_begin = 0u;
    uint size = sum_up_to<BLOCK>(end - begin);
    if (begin != 0u) atomicAdd(&bucket_begin, begin);
    for (uint k = begin; k < end && size - end + k < MOST_HELD; ++k) scratch[size - end + k] = tile + k;
    if (lane == BLOCK - 1u) bucket_size = size;
    __syncthreads();
    return Bucket{bucket_begin, bucket_size, tiles};
  } else {
    Run run = run_of<FROM_TILES>(p, buf, bucket, 0u);
    return Bucket{run.begin, run.end - run.begin, 1u};
  }
}
// Returns the index of the bucket's k-th sphere among the split spheres. Past the end it is the last one's; in an empty
// bucket it is 0.
template <bool FROM_TILES>
__device__ inline uint source_index(Bucket b, uint k) {
  if (b.size == 0u) return 0u;
  return FROM_TILES ? scratch[min(k, b.size - 1u)] : b.begin + min(k, b.size - 1u);
}

__device__ inline void store_sorted(const Params& p, const KernelBuffers& buf, vec4 sphere, uint i, uint at) {
  buf.sorted[at] = sphere;
  if (p.sort.index_in_w == 0u) buf.id[at] = buf.from_id[i];
  buf.sorted_count[at] = 0u;
}

// Computes an exclusive prefix sum over `scratch`: counts of cells become the index in the bucket at which each begins.
// The table gets the same index counted over all spheres.
__device__ inline void begin_cells(const Params& p, const KernelBuffers& buf, Bucket b, uint low) {
  uint lane = threadIdx.x;
  __syncthreads();
  uint own = 0u;
  for (uint k = 0u; k < CELLS_PER_BUCKET / BLOCK; ++k) own += scratch[lane * (CELLS_PER_BUCKET / BLOCK) + k];
  uint upto = sum_up_to<BLOCK>(own) - own;
  for (uint k = 0u; k < CELLS_PER_BUCKET / BLOCK; ++k) {
    uint counted = scratch[lane * (CELLS_PER_BUCKET / BLOCK) + k];
    scratch[lane * (CELLS_PER_BUCKET / BLOCK) + k] = upto;
    upto += counted;
  }
  __syncthreads();
  for (uint k = lane; k < 1u << p.sort.bucket_shift; k += BLOCK)
    if (low + k <= p.grid.cell_slots) buf.cell[low + k] = b.begin + scratch[k];
}

template <bool FROM_TILES, bool DENSE>
__device__ inline void sort_bucket(const Params& p, const KernelBuffers& buf, Bucket b, uint low) {
  uint lane = threadIdx.x;
  uint from[SORT_EACH];           // indices of the thread's spheres
  uint cell_and_rank[SORT_EACH];  // of each, in the bucket; the rank in the upper half
  for (uint k = 0u; k < SORT_EACH; ++k) from[k] = source_index<FROM_TILES>(b, lane + k * BLOCK);
  __syncthreads();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) scratch[c] = 0u;
  for (uint k = 0u; k < SORT_EACH; ++k) cell_and_rank[k] = slot_of(buf.position[from[k]], DENSE, p.grid) - low;
  __syncthreads();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * BLOCK < b.size) cell_and_rank[k] |= atomicAdd(&scratch[cell_and_rank[k]], 1u) << 16;
  begin_cells(p, buf, b, low);
  for (uint k = 0u; k < SORT_EACH; ++k)
    cell_and_rank[k] = scratch[cell_and_rank[k] % CELLS_PER_BUCKET] + (cell_and_rank[k] >> 16);
  __syncthreads();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * BLOCK < b.size) scratch[cell_and_rank[k]] = from[k];
  __syncthreads();
  for (uint k = lane; k < b.size; k += BLOCK) store_sorted(p, buf, buf.position[scratch[k]], scratch[k], b.begin + k);
}

template <bool FROM_TILES, bool DENSE>
__device__ inline void sort_oversized_bucket(const Params& p, const KernelBuffers& buf, Bucket b, uint low) {
  uint lane = threadIdx.x;
  __syncthreads();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) scratch[c] = 0u;
  __syncthreads();
  for (uint r = lane / RUN_THREADS<FROM_TILES>; r < b.runs; r += BLOCK / RUN_THREADS<FROM_TILES>) {
    Run run = run_of<FROM_TILES>(p, buf, group_index(p), r);
    for (uint i = run.begin + lane % RUN_THREADS<FROM_TILES>; i < run.end; i += RUN_THREADS<FROM_TILES>)
      atomicAdd(&scratch[slot_of(buf.position[i], DENSE, p.grid) - low], 1u);
  }
  begin_cells(p, buf, b, low);
  __syncthreads();
  for (uint r = lane / RUN_THREADS<FROM_TILES>; r < b.runs; r += BLOCK / RUN_THREADS<FROM_TILES>) {
    Run run = run_of<FROM_TILES>(p, buf, group_index(p), r);
    for (uint i = run.begin + lane % RUN_THREADS<FROM_TILES>; i < run.end; i += RUN_THREADS<FROM_TILES>) {
      vec4 sphere = buf.position[i];
      store_sorted(p, buf, sphere, i, b.begin + atomicAdd(&scratch[slot_of(sphere, DENSE, p.grid) - low], 1u));
    }
  }
}

template <bool FROM_TILES, bool DENSE>
__global__ void __launch_bounds__(BLOCK, 4) grid_sort(Params p, KernelBuffers buf) {
  grid_dependency_sync();  // CUDA only: the split has written the spheres, and the search of the last step has ended
  if (group_index(p) >= p.sort.buckets) return;
  uint low = group_index(p) << p.sort.bucket_shift;
  for (uint k = threadIdx.x; low == 0u && k < SUMMARY_SLOTS * SUMMARY_WORDS; k += BLOCK) buf.summary[k] = 0u;
  Bucket b = find_bucket<FROM_TILES>(p, buf, group_index(p));
  if (b.size <= MOST_HELD) {
    sort_bucket<FROM_TILES, DENSE>(p, buf, b, low);
  } else {
    sort_oversized_bucket<FROM_TILES, DENSE>(p, buf, b, low);
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
