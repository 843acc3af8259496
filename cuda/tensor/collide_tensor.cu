// SPDX-License-Identifier: MIT
// Each unordered pair once, through tensor cores: a group holds TENSOR_ROWS spheres, its rows, as fragments of matrix
// A, and tests them against later spheres, its columns, which pass through shared memory in tiles. A sum of products is
// negative where a pair may collide (tensor_form.h). The signs of a thread's sums are joined, 32 pairs at a time; where
// one is set, the pairs are queued, and the warp decides them, a thread per pair. The tiles of all blocks of rows form
// one line, of which each group takes p.search.columns_per_group.
//
// CUDA only: OpenGL has no cooperative matrices
#include "cuda/collide/collide.cuh"
#include "cuda/tensor/product.cuh"

namespace spherepair {

constexpr uint WARPS = TENSOR_BLOCK / 32u;
constexpr uint PRODUCTS = TENSOR_ROWS / (WARPS / 4u) / PRODUCT_ROWS;  // of each four warps with a tile
constexpr uint ENTRY_COLUMNS = 64u;                                   // of a queue entry: 2 rows, 16 of these columns
constexpr uint ENTRIES = TENSOR_COLUMNS / ENTRY_COLUMNS;              // that a thread has of one product
constexpr uint QUEUE = 32u + 32u * ENTRIES;                           // it is emptied once it holds 32

// The candidate pairs of one warp.
struct NearQueue {
  uint* entries;
  uint first_row = 0u;  // of the warp
  uint length = 0u;

  __device__ void add(bool near, uint columns, uint product, uint lane) {
    uint threads = __ballot_sync(~0u, near);
    if (near) entries[length + __popc(threads & ((1u << lane) - 1u))] = columns << 8 | product << 5 | lane;
    length += __popc(threads);
  }

  template <bool EQUAL_RADII, bool LISTED>
  __device__ void resolve(Collider<EQUAL_RADII, LISTED>& collider, uint lane) {
    __syncwarp();
    for (uint k = 0u; k < length; ++k) {
      uint thread = entries[k] % 32u;
      uint product = entries[k] / 32u % 8u;
      uint i = first_row + product * PRODUCT_ROWS + thread / 4u + lane % 2u * 8u;
      uint j = entries[k] / 256u * ENTRY_COLUMNS + lane / 4u * 8u + thread % 4u * 2u + lane / 2u % 2u;
      if (i < j && j < collider.p.n) collider.test_stored_pair(i, j);
    }
    __syncwarp();
    length = 0u;
  }
};

// Queues what is near of one product.
__device__ inline void queue_near(NearQueue& queue, const float (&sum)[SUMS], uint tile, uint product, uint lane) {
  uint signs[ENTRIES] = {};
  uint any = 0u;
#pragma unroll
  for (uint k = 0u; k < SUMS; ++k) signs[k / (SUMS / ENTRIES)] |= float_bits(sum[k]);
#pragma unroll
  for (uint e = 0u; e < ENTRIES; ++e) any |= signs[e];
  if (__ballot_sync(~0u, int(any) < 0) == 0u) return;
#pragma unroll
  for (uint e = 0u; e < ENTRIES; ++e) queue.add(int(signs[e]) < 0, tile * ENTRIES + e, product, lane);
}

template <bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(TENSOR_BLOCK, 1) collide_tensor(Params p, KernelBuffers buf) {
  __shared__ RingMemory memory;
  __shared__ uint entries[WARPS * QUEUE];
  Collider<EQUAL_RADII, LISTED> collider(p, buf);
  uint warp = threadIdx.x / 32u, lane = threadIdx.x % 32u;
  const uint* forms = reinterpret_cast<const uint*>(buf.sorted);
  uint64_t first = uint64_t(group_index(p)) * p.search.columns_per_group, all = tensor_tiles(p.n);
  if (first >= all) return;
  uint count = uint(min(uint64_t(p.search.columns_per_group), all - first));
  TilePosition position(p.n, first);
  ColumnRing ring{memory, reinterpret_cast<const char*>(forms), position, count};
  NearQueue queue{entries + warp * QUEUE};
  collider.start_totals();
  ring.start(WARPS);
  for (uint turn = 0u; turn < count;) {
    queue.first_row = position.block * TENSOR_ROWS + warp / 4u * (PRODUCTS * PRODUCT_ROWS) + warp % 4u * 16u;
    uint rows[PRODUCTS][4];
#pragma unroll
    for (uint k = 0u; k < PRODUCTS; ++k) load_rows(rows[k], forms, queue.first_row + k * PRODUCT_ROWS, lane);
    uint end = turn + min(count - turn, position.left()), tile = position.tile;
    position.advance(end - turn);
#pragma unroll 1
    for (; turn < end; ++turn, ++tile) {
      ring.refill(turn);
      uint64_t columns = matrix_descriptor(ring.wait(turn));
#pragma unroll
      for (uint k = 0u; k < PRODUCTS; ++k) {
        float sum[SUMS];
        multiply(sum, rows[k], columns);
        if (k + 1u == PRODUCTS) ring.release(turn, lane);
        queue_near(queue, sum, tile, k, lane);
        if (queue.length >= 32u) queue.resolve(collider, lane);
      }
    }
    queue.resolve(collider, lane);
  }
  collider.finish_totals();
}

Entry collide_tensor_kernel(uint, Variant variant) {
  return pick_variant<TENSOR_BLOCK>(variant, [](auto, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_tensor<equal(), listed()>);
  });
}

}  // namespace spherepair
