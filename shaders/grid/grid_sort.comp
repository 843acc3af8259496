#version 450
// SPDX-License-Identifier: MIT
// A group takes the spheres of a bucket and puts them into the order of its cells: counts them by cell, adds the counts
// up, writes where the cells begin, puts the spheres' numbers into order and copies them in that order, so that
// neighbours are written by neighbours. A bucket of more spheres than SORT_EACH a thread is copied as it comes. Totals
// are cleared here.
#define CELL_ACCESS
#define ID_ACCESS
#define SORTS_SPHERES
#include "shaders/grid/grid.glsl"
#include "shaders/grid/group_sum.glsl"

layout(std430, binding = SLOT_SPLIT_ID) restrict readonly buffer FromIdBuffer { uint from_id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict writeonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(std430, binding = SLOT_BUCKET) restrict readonly buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;
const uint HELD = SORT_EACH * BLOCK;
shared uint sorted_index[CELLS_PER_BUCKET];  // where the bucket's spheres stand; then, in the bucket, of the next
                                             // sphere of each cell; then its spheres by cell

// The spheres of a bucket: from which place on they go, and how many they are. They stand in runs; of a crowd,
// RUN_THREADS threads walk through each.
struct Bucket {
  uint begin, size, runs;
};
struct Run {
  uint begin, end;
};
#ifdef FROM_TILES
const uint RUN_THREADS = 32u;
shared uint bucket_begin, bucket_size;
// Of a tile.
Run run_of(uint bucket, uint tile) {
  uint run = bucket_cursor[tile * BUCKETS_AT_MOST + bucket];
  return Run(tile * SPLIT_TILE + begin_in_tile(run), tile * SPLIT_TILE + end_in_tile(run));
}
// A thread finds the run of each tile.
Bucket find_bucket(uint bucket) {
  uint lane = gl_LocalInvocationID.x;
  uint tiles = (p.n + SPLIT_TILE - 1u) / SPLIT_TILE;
  uint tile = min(lane, tiles - 1u) * SPLIT_TILE;
  Run run = run_of(bucket, min(lane, tiles - 1u));
  uint begin = lane < tiles ? run.begin - tile : 0u;
  uint end = lane < tiles ? run.end - tile : 0u;
  if (lane == 0u) bucket_begin = 0u;
  uint size = sum_up_to(end - begin);
  if (begin != 0u) atomicAdd(bucket_begin, begin);
  for (uint k = begin; k < end && size - end + k < HELD; ++k) sorted_index[size - end + k] = tile + k;
  if (lane == BLOCK - 1u) bucket_size = size;
  barrier();
  return Bucket(bucket_begin, bucket_size, tiles);
}
// Where the k-th sphere of the bucket stands, or behind its last one that one; any sphere where it has none.
uint held(Bucket b, uint k) { return b.size != 0u ? sorted_index[min(k, b.size - 1u)] : 0u; }
#else
const uint RUN_THREADS = uint(BLOCK);
// The only one.
Run run_of(uint bucket, uint run) {
  uint begin = bucket == 0u ? 0u : bucket_cursor[p.first_bucket + bucket - 1u];
  return Run(begin, bucket_cursor[p.first_bucket + bucket]);
}
Bucket find_bucket(uint bucket) {
  Run run = run_of(bucket, 0u);
  return Bucket(run.begin, run.end - run.begin, 1u);
}
uint held(Bucket b, uint k) { return b.size != 0u ? b.begin + min(k, b.size - 1u) : 0u; }
#endif

// Sphere i of those that were split.
void put(vec4 sphere, uint i, uint at) {
  sorted[at] = sphere;
  if ((p.indices & INDEX_IN_W) == 0u) id[at] = from_id[i];
  sorted_count[at] = 0u;
}

// Makes of the counts where the cells begin, in the bucket and in the table.
void begin_cells(Bucket b, uint low) {
  uint lane = gl_LocalInvocationID.x;
  barrier();
  uint own = 0u;
  for (uint k = 0u; k < CELLS_PER_BUCKET / BLOCK; ++k) own += sorted_index[lane * (CELLS_PER_BUCKET / BLOCK) + k];
  uint upto = sum_up_to(own) - own;
  for (uint k = 0u; k < CELLS_PER_BUCKET / BLOCK; ++k) {
    uint counted = sorted_index[lane * (CELLS_PER_BUCKET / BLOCK) + k];
    sorted_index[lane * (CELLS_PER_BUCKET / BLOCK) + k] = upto;
    upto += counted;
  }
  barrier();
  for (uint k = lane; k < 1u << p.bucket_shift; k += BLOCK)
    if (low + k <= p.cell_slots) cell[low + k] = b.begin + sorted_index[k];
}

void sort_held(Bucket b, uint low) {
  uint lane = gl_LocalInvocationID.x;
  uint from[SORT_EACH];           // where the thread's spheres stand
  uint cell_and_rank[SORT_EACH];  // of each, in the bucket; the rank in the upper half
  for (uint k = 0u; k < SORT_EACH; ++k) from[k] = held(b, lane + k * BLOCK);
  barrier();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) sorted_index[c] = 0u;
  for (uint k = 0u; k < SORT_EACH; ++k) cell_and_rank[k] = slot_of(sphere_of(from[k]), DENSE, p) - low;
  barrier();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * BLOCK < b.size) cell_and_rank[k] |= atomicAdd(sorted_index[cell_and_rank[k]], 1u) << 16;
  begin_cells(b, low);
  for (uint k = 0u; k < SORT_EACH; ++k)
    cell_and_rank[k] = sorted_index[cell_and_rank[k] % CELLS_PER_BUCKET] + (cell_and_rank[k] >> 16);
  barrier();
  for (uint k = 0u; k < SORT_EACH; ++k)
    if (lane + k * BLOCK < b.size) sorted_index[cell_and_rank[k]] = from[k];
  barrier();
  for (uint k = lane; k < b.size; k += BLOCK) put(sphere_of(sorted_index[k]), sorted_index[k], b.begin + k);
}

void sort_oversized_bucket(Bucket b, uint low) {
  uint lane = gl_LocalInvocationID.x;
  barrier();
  for (uint c = lane; c < CELLS_PER_BUCKET; c += BLOCK) sorted_index[c] = 0u;
  barrier();
  for (uint r = lane / RUN_THREADS; r < b.runs; r += BLOCK / RUN_THREADS) {
    Run run = run_of(group_index(), r);
    for (uint i = run.begin + lane % RUN_THREADS; i < run.end; i += RUN_THREADS)
      atomicAdd(sorted_index[slot_of(sphere_of(i), DENSE, p) - low], 1u);
  }
  begin_cells(b, low);
  barrier();
  for (uint r = lane / RUN_THREADS; r < b.runs; r += BLOCK / RUN_THREADS) {
    Run run = run_of(group_index(), r);
    for (uint i = run.begin + lane % RUN_THREADS; i < run.end; i += RUN_THREADS) {
      vec4 sphere = sphere_of(i);
      put(sphere, i, b.begin + atomicAdd(sorted_index[slot_of(sphere, DENSE, p) - low], 1u));
    }
  }
}

void main() {
  if (group_index() >= p.buckets) return;
  uint low = group_index() << p.bucket_shift;
  for (uint k = gl_LocalInvocationID.x; low == 0u && k < SUMMARY_SLOTS * SUMMARY_WORDS; k += BLOCK) summary[k] = 0u;
  Bucket b = find_bucket(group_index());
  if (b.size <= HELD) {
    sort_held(b, low);
  } else {
    sort_oversized_bucket(b, low);
  }
}
