// SPDX-License-Identifier: MIT
// One group per SPLIT_TILE spheres: sorts their indices by bucket in shared memory, copies the spheres in that order
// within their tile, and writes the range of each bucket. With at most BUCKETS_AT_MOST buckets no count across tiles is
// needed: grid_sort collects the spheres of its bucket from all tiles. The previous step's search may still be running:
// it reads nothing that is written here, and writes nothing that is read here.
#include "cuda/grid/grid.cuh"
#include "cuda/grid/group_sum.cuh"

namespace spherepair {

constexpr uint BLOCK = SPLIT_BLOCK;

template <bool DENSE>
__global__ void __launch_bounds__(BLOCK, 2) split_tiles(Params p, KernelBuffers buf) {
  __shared__ uint cursor[BUCKETS_AT_MOST];  // counts of the buckets, then where each begins in the tile
  __shared__ uint order[SPLIT_TILE];        // the spheres of the tile by bucket: index in the tile
  uint lane = threadIdx.x;
  uint first = group_index(p) * SPLIT_TILE;
  if (first >= p.n) return;
  uint end = min(first + SPLIT_TILE, p.n);
  cursor[lane] = 0u;
  uint bucket[SPLIT_EACH];
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    bucket[k] = slot_of(buf.position[min(first + k * BLOCK + lane, end - 1u)], DENSE, p.grid) >> p.sort.bucket_shift;
  __syncthreads();
  uint rank[SPLIT_EACH];  // among the spheres of its bucket in the tile
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * BLOCK + lane < end) rank[k] = atomicAdd(&cursor[bucket[k]], 1u);
  __syncthreads();
  uint own = cursor[lane];
  uint upto = sum_up_to<BLOCK>(own);
  buf.bucket_cursor[group_index(p) * BUCKETS_AT_MOST + lane] = run_in_tile(upto - own, upto);
  cursor[lane] = upto - own;
  __syncthreads();
  for (uint k = 0u; k < SPLIT_EACH; ++k)
    if (first + k * BLOCK + lane < end) order[cursor[bucket[k]] + rank[k]] = k * BLOCK + lane;
  __syncthreads();
  for (uint at = first + lane; at < end; at += BLOCK) {
    uint i = first + order[at - first];
    vec4 sphere = buf.position[i];
    if (p.sort.index_in_w != 0u) {
      sphere.w = bits_float(i);
    } else {
      buf.id[at] = i;
    }
    buf.sorted[at] = sphere;
  }
  grid_dependency_sync();  // CUDA only: the next launch needs the previous search done too
}

Entry split_tiles_kernel(uint, Variant variant) {
  return variant.dense ? reinterpret_cast<Entry>(&split_tiles<true>) : reinterpret_cast<Entry>(&split_tiles<false>);
}

}  // namespace spherepair
