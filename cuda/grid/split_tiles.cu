// SPDX-License-Identifier: MIT
// Where one group tells all buckets apart, nothing need be counted before the split: a group takes SPLIT_TILE spheres,
// puts their numbers into the order of the buckets, copies them in that order to where the tile stood, and writes where
// in it each bucket is. grid_sort collects the spheres of its bucket from all tiles. The search before may be under way
// still: nothing that it reads is written here, and nothing that it writes is read.
#include "common/shared/cell.h"
#include "cuda/grid/group_sum.cuh"
#include "cuda/kernels.cuh"

namespace spherepair {

template <bool DENSE>
__global__ void __launch_bounds__(SPLIT_BLOCK, 2) split_tiles(Params p, KernelBuffers w) {
  __shared__ uint sorted_index[BUCKETS_AT_MOST];  // in the tile: where each bucket begins; counts before that
  __shared__ uint order[SPLIT_TILE];              // the spheres of the tile by bucket: their numbers in it
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  sorted_index[lane] = 0u;
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(w.position[min(first + k * SPLIT_BLOCK + lane, end - 1u)], DENSE, p) >> p.bucket_shift;
  __syncthreads();
  uint rank[SPLIT_EACH];  // in the bucket, of the tile's spheres
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * SPLIT_BLOCK + lane < end) rank[k] = atomicAdd(&sorted_index[bucket[k]], 1u);
  __syncthreads();
  uint own = sorted_index[lane];
  uint upto = sum_up_to<SPLIT_BLOCK>(own);
  w.bucket_cursor[group_index(p) * BUCKETS_AT_MOST + lane] = run_in_tile(upto - own, upto);
  sorted_index[lane] = upto - own;
  __syncthreads();
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * SPLIT_BLOCK + lane < end) order[sorted_index[bucket[k]] + rank[k]] = k * SPLIT_BLOCK + lane;
  __syncthreads();
  for (uint at = first + lane; at < end; at += SPLIT_BLOCK) {
    uint i = first + order[at - first];
    vec4 sphere = w.position[i];
    if ((p.indices & INDEX_IN_W) != 0u) {
      sphere.w = bits_float(i);
    } else {
      w.id[at] = i;
    }
    w.sorted[at] = sphere;
  }
  grid_dependency_sync();
}

Entry split_tiles_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&split_tiles<true>) : reinterpret_cast<Entry>(&split_tiles<false>);
}

}  // namespace spherepair
