// SPDX-License-Identifier: MIT
// Tests each unordered pair once, through tensor cores: a group holds TENSOR_ROWS spheres, its rows, as fragments of
// matrix A, and tests them against later spheres, its columns, which pass through shared memory in tiles. A sum of
// products is negative where a pair may collide (tensor_form.h). The tiles of all blocks of rows form one line, of
// which each group takes p.search.tiles_per_group.
#include "cuda/collide/collide.cuh"
#include "cuda/tensor/product.cuh"

namespace spherepair {

// CUDA only from here: four warps compute a product, and each thread knows the rows and columns of its sums. It joins
// the signs of 32 sums and queues these pairs if one is negative. The warp decides queued pairs, a thread for 32 pairs.
constexpr uint WARPS = TENSOR_BLOCK / 32u;
constexpr uint PRODUCTS = TENSOR_ROWS / (WARPS / 4u) / PRODUCT_ROWS;  // products of four warps with a tile
constexpr uint ENTRY_COLUMNS = 64u;  // columns a queue entry spans: it has 2 rows, 16 of these columns
constexpr uint ENTRIES = TENSOR_COLUMNS / ENTRY_COLUMNS;  // entries that a thread has of one product
constexpr uint QUEUE = 32u + 32u * ENTRIES;               // the queue is emptied once it holds 32

// Queues the candidate pairs of one warp.
struct NearQueue {
  uint* entries;
  uint first_row = 0u;  // of the warp
  uint length = 0u;

  __device__ void add(bool near, uint columns, uint product, uint lane) {
    uint threads = __ballot_sync(~0u, near);
    if (near) entries[length + __popc(threads & ((1u << lane) - 1u))] = columns << 8 | product << 5 | lane;
    length += __popc(threads);
  }

  // Tests all pairs of an entry by the float32 filter first, then decides the few that remain: so all loads go out
  // together.
  template <bool EQUAL_RADII, bool LISTED>
  __device__ void resolve(Collider<EQUAL_RADII, LISTED>& collider, uint lane) {
    __syncwarp();
    for (uint first = 0u; first < length; first += 32u) {
      if (first + lane >= length) continue;
      uint entry = entries[first + lane];
      uint i = first_row + entry / 32u % 8u * PRODUCT_ROWS + entry % 32u / 4u;
      uint j = entry / 256u * ENTRY_COLUMNS + entry % 4u * 2u;
      const Params& p = collider.p;
      const vec4* position = collider.buf.position;
      vec4 row[2] = {position[min(i, p.n - 1u)], position[min(i + 8u, p.n - 1u)]};
      uint candidates = 0u;
#pragma unroll 8
      for (uint c = 0u; c < 16u; ++c) {
        uint column = j + c / 2u * 8u + c % 2u;
        vec4 b = position[min(column, p.n - 1u)];
        for (uint h = 0u; h < 2u; ++h)
          if (i + 8u * h < column && column < p.n && collider.in_reach(row[h], b)) candidates |= 1u << (2u * c + h);
      }
      for (; candidates != 0u; candidates &= candidates - 1u) {
        uint k = lowest_bit(candidates);
        collider.test_stored_pair(i + k % 2u * 8u, j + k / 4u * 8u + k / 2u % 2u);
      }
    }
    __syncwarp();
    length = 0u;
  }
};

// Queues the pairs of one product that may be near.
__device__ inline void queue_near(NearQueue& queue, const uint (&sum)[WORDS], uint tile, uint product, uint lane) {
  uint signs[ENTRIES] = {};
  uint any = 0u;
#pragma unroll
  for (uint k = 0u; k < WORDS; ++k) signs[k / (WORDS / ENTRIES)] |= sum[k];
#pragma unroll
  for (uint e = 0u; e < ENTRIES; ++e) any |= signs[e];
  if (__ballot_sync(~0u, (any & SIGNS) != 0u) == 0u) return;
#pragma unroll
  for (uint e = 0u; e < ENTRIES; ++e) queue.add((signs[e] & SIGNS) != 0u, tile * ENTRIES + e, product, lane);
}

template <bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(TENSOR_BLOCK, 1) collide_tensor(Params p, KernelBuffers buf) {
  __shared__ RingMemory memory;
  __shared__ uint entries[WARPS * QUEUE];
  Collider<EQUAL_RADII, LISTED> collider(p, buf);
  uint warp = threadIdx.x / 32u, lane = threadIdx.x % 32u;
  const uint* forms = reinterpret_cast<const uint*>(buf.sorted);
  uint64_t first = uint64_t(group_index(p)) * p.search.tiles_per_group, all = tensor_tiles(p.n);
  if (first >= all) return;
  uint count = uint(min(uint64_t(p.search.tiles_per_group), all - first));
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
        uint sum[WORDS];
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
// until here

Entry collide_tensor_kernel(uint, Variant variant) {
  return pick_variant<TENSOR_BLOCK>(variant, [](auto, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_tensor<equal(), listed()>);
  });
}

}  // namespace spherepair
