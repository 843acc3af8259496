#version 450
// SPDX-License-Identifier: MIT
// One group per bucket: a counting sort of its spheres by cell. It counts them by cell, computes the prefix sum, writes
// where the cells begin, sorts the spheres' indices in shared memory and copies the spheres in that order, so that
// writes are coalesced. An oversized bucket, of more spheres than SORT_EACH a thread, is scattered directly. Totals are
// cleared here.
#define CELL_ACCESS
#define ID_ACCESS
#include "shaders/grid/grid.glsl"
#include "shaders/grid/group_sum.glsl"

layout(std430, binding = SLOT_SPLIT_ID) restrict readonly buffer FromIdBuffer { uint from_id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict writeonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(std430, binding = SLOT_BUCKET) restrict readonly buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;
const uint MOST_HELD = SORT_EACH * BLOCK;
const uint RUN_THREADS = FROM_TILES ? 32u : uint(BLOCK);  // threads that share a run of an oversized bucket
shared uint
    scratch[CELLS_PER_BUCKET];  // indices of the bucket's spheres, then cursors of its cells, then sorted indices
shared uint bucket_begin, bucket_size;

// The spheres of a bucket: their first sorted index, their number, and the runs in which they come.
struct Bucket {
  uint begin, size, runs;
};
struct Run {
  uint begin, end;
};

// Returns the run of a tile (FROM_TILES), else the only one.
Run run_of(uint bucket, uint tile) {
  if (FROM_TILES) {
    uint run = bucket_cursor[tile * BUCKETS_AT_MOST + bucket];
    return Run(tile * SPLIT_TILE + begin_in_tile(run), tile * SPLIT_TILE + end_in_tile(run));
  } else {
    uint begin = bucket == 0u ? 0u : bucket_cursor[p.sort.first_bucket + bucket - 1u];
    return Run(begin, bucket_cursor[p.sort.first_bucket + bucket]);
  }
}

// Finds the bucket's spheres. FROM_TILES: one thread per tile lists the spheres of its run in `scratch`.
Bucket find_bucket(uint bucket) {
  uint lane = gl_LocalInvocationID.x;
  if (FROM_TILES) {
    uint tiles = (p.n + SPLIT_TILE - 1u) / SPLIT_TILE;
    uint tile = min(lane, tiles - 1u) * SPLIT_TILE;
    Run run = run_of(bucket, min(lane, tiles - 1u));
    uint begin = lane < tiles ? run.begin - tile : 0u;
    uint end = lane < tiles ? run.end - tile : 0u;
    if (lane == 0u) bucket_begin = 0u;
    uint size = sum_up_to(end - begin);
    if (begin != 0u) atomicAdd(bucket_begin, begin);
    for (uint k = begin; k < end && size - end + k < MOST_HELD; ++k) scratch[size - end + k] = tile + k;
    if (lane == BLOCK - 1u) bucket_size = size;
    barrier();
    return Bucket(bucket_begin, bucket_size, tiles);
  } else {
    Run run = run_of(bucket, 0u);
    return Bucket(run.begin, run.end - run.begin, 1u);
  }
}
// Returns the index of the bucket's k-th sphere among the split spheres. Past the end it is the last one's; in an empty
// bucket it is 0.
uint source_index(Bucket b, uint k) {
  if (b.size == 0u) return 0u;
  return FROM_TILES ? scratch[min(k, b.size - 1u)] : b.begin + min(k, b.size - 1u);
}

void store_sorted(vec4 sphere, uint i, uint at) {
  sorted[at] = sphere;
  if (p.sort.index_in_w == 0u) id[at] = from_id[i];
  sorted_count[at] = 0u;
}

// Computes an exclusive prefix sum over `scratch`: counts of cells become the index in the bucket at which each begins.
// The table gets the same index counted over all spheres.
void begin_cells(Bucket b, uint low) {
  uint lane = gl_LocalInvocationID.x;
  barrier();
  uint own = 0u;
  for (uint k = 0u; k < CELLS_PER_BUCKET / BLOCK; ++k) own += scratch[lane * (CELLS_PER_BUCKET / BLOCK) + k];
  uint upto = sum_up_to(own) - own;
  for (uint k = 0u; k < CELLS_PER_BUCKET / BLOCK; ++k) {
    uint counted = scratch[lane * (CELLS_PER_BUCKET / BLOCK) + k];
    scratch[lane * (CELLS_PER_BUCKET / BLOCK) + k] = upto;
    upto += counted;
  }
  barrier();
  for (uint k = lane; k < 1u << p.sort.bucket_shift; k += BLOCK)
    if (low + k <= p.grid.cell_slots) cell[low + k] = b.begin + scratch[k];
}

void sort_bucket(Bucket b, uint low) {
  uint lane = gl_LocalInvocationID.x;
  uint from[SORT_EACH];           // indices of the thread's spheres
  uint cell_and_rank[SORT_EACH];  // of each, in the bucket; the rank in the upper half
  for (uint k = 0u; k < SORT_EACH; ++k) from[k] = source_index(b, lane + k * BLOCK);
  barrier();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) scratch[c] = 0u;
  for (uint k = 0u; k < SORT_EACH; ++k) cell_and_rank[k] = slot_of(position[from[k]], DENSE, p.grid) - low;
  barrier();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * BLOCK < b.size) cell_and_rank[k] |= atomicAdd(scratch[cell_and_rank[k]], 1u) << 16;
  begin_cells(b, low);
  for (uint k = 0u; k < SORT_EACH; ++k)
    cell_and_rank[k] = scratch[cell_and_rank[k] % CELLS_PER_BUCKET] + (cell_and_rank[k] >> 16);
  barrier();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * BLOCK < b.size) scratch[cell_and_rank[k]] = from[k];
  barrier();
  for (uint k = lane; k < b.size; k += BLOCK) store_sorted(position[scratch[k]], scratch[k], b.begin + k);
}

void sort_oversized_bucket(Bucket b, uint low) {
  uint lane = gl_LocalInvocationID.x;
  barrier();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) scratch[c] = 0u;
  barrier();
  for (uint r = lane / RUN_THREADS; r < b.runs; r += BLOCK / RUN_THREADS) {
    Run run = run_of(group_index(), r);
    for (uint i = run.begin + lane % RUN_THREADS; i < run.end; i += RUN_THREADS)
      atomicAdd(scratch[slot_of(position[i], DENSE, p.grid) - low], 1u);
  }
  begin_cells(b, low);
  barrier();
  for (uint r = lane / RUN_THREADS; r < b.runs; r += BLOCK / RUN_THREADS) {
    Run run = run_of(group_index(), r);
    for (uint i = run.begin + lane % RUN_THREADS; i < run.end; i += RUN_THREADS) {
      vec4 sphere = position[i];
      store_sorted(sphere, i, b.begin + atomicAdd(scratch[slot_of(sphere, DENSE, p.grid) - low], 1u));
    }
  }
}

void main() {
  if (group_index() >= p.sort.buckets) return;
  uint low = group_index() << p.sort.bucket_shift;
  for (uint k = gl_LocalInvocationID.x; low == 0u && k < SUMMARY_SLOTS * SUMMARY_WORDS; k += BLOCK) summary[k] = 0u;
  Bucket b = find_bucket(group_index());
  if (b.size <= MOST_HELD) {
    sort_bucket(b, low);
  } else {
    sort_oversized_bucket(b, low);
  }
}
