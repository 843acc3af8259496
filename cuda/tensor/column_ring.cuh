// SPDX-License-Identifier: MIT
// The columns of collide_tensor: tiles of forms that the bulk copy engine copies into a ring in shared memory. Every
// warp of the group reads each tile; warp 0 also refills the ring.
//
// CUDA only: GLSL has no bulk copies
#pragma once

#include "common/shared/tensor_form.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__device__ inline uint shared_address(const void* data) { return uint(__cvta_generic_to_shared(data)); }

// A barrier in shared memory. A phase completes after so many arrivals and the bytes that one of them announced.
struct PhaseBarrier {
  uint64_t state;

  __device__ void start(uint arrivals) {
    asm volatile("mbarrier.init.shared::cta.b64 [%0], %1;" ::"r"(shared_address(&state)), "r"(arrivals) : "memory");
  }
  __device__ void arrive() {
    asm volatile("mbarrier.arrive.shared::cta.b64 _, [%0];" ::"r"(shared_address(&state)) : "memory");
  }
  __device__ void copy(void* target, const void* source, uint bytes) {
    uint barrier = shared_address(&state);
    asm volatile("mbarrier.arrive.expect_tx.shared::cta.b64 _, [%0], %1;" ::"r"(barrier), "r"(bytes) : "memory");
    asm volatile("cp.async.bulk.shared::cluster.global.mbarrier::complete_tx::bytes [%0], [%1], %2, [%3];" ::"r"(
                     shared_address(target)),
                 "l"(source), "r"(bytes), "r"(barrier)
                 : "memory");
  }
  __device__ void wait(uint phase) {
    asm volatile(
        "{ .reg .pred done;\n"
        "again: mbarrier.try_wait.parity.shared::cta.b64 done, [%0], %1;\n"
        "@!done bra again; }" ::"r"(shared_address(&state)),
        "r"(phase & 1u)
        : "memory");
  }
};

// Walks through a group's tiles in order. Each block of rows begins with the tile of its first row.
struct TilePosition {
  uint tiles;  // tiles of all columns
  uint block = 0u, tile = 0u;

  __device__ TilePosition(uint n, uint64_t skipped) : tiles((n + TENSOR_COLUMNS - 1u) / TENSOR_COLUMNS) {
    while (skipped >= tiles - first()) {
      skipped -= tiles - first();
      ++block;
    }
    tile = first() + uint(skipped);
  }
  __device__ uint first() const { return block * (TENSOR_ROWS / TENSOR_COLUMNS); }
  __device__ uint left() const { return tiles - tile; }  // tiles left in this block of rows
  __device__ void advance(uint count) {
    tile += count;
    if (tile < tiles) return;
    ++block;
    tile = first();
  }
};

constexpr uint RING_STAGES = 4u;
constexpr uint TILE_BYTES = TENSOR_COLUMNS * sizeof(TensorForm);
constexpr uint STAGES_BEHIND = RING_STAGES / 2u;  // tiles that a warp may be behind warp 0 before warp 0 waits

struct RingMemory {
  alignas(128) char tiles[RING_STAGES][TILE_BYTES];
  PhaseBarrier filled[RING_STAGES], released[RING_STAGES];
};

struct ColumnRing {
  RingMemory& memory;
  const char* forms;
  TilePosition next;  // the next tile to copy
  uint count;         // number of the group's tiles

  __device__ void fill(uint turn) {
    memory.filled[turn % RING_STAGES].copy(memory.tiles[turn % RING_STAGES], forms + size_t(next.tile) * TILE_BYTES,
                                           TILE_BYTES);
    next.advance(1u);
  }
  __device__ void start(uint warps) {
    if (threadIdx.x == 0u) {
      for (uint k = 0u; k < RING_STAGES; ++k) {
        memory.filled[k].start(1u);
        memory.released[k].start(warps);
      }
      asm volatile("fence.mbarrier_init.release.cluster;" ::: "memory");
      asm volatile("fence.proxy.async;" ::: "memory");
      for (uint k = 0u; k < RING_STAGES && k < count; ++k) fill(k);
    }
    __syncthreads();
  }
  // At the group's tile number `turn`: refills the stage of an earlier tile, once all warps have released it.
  __device__ void refill(uint turn) {
    if (threadIdx.x >= 32u) return;
    uint ahead = turn - STAGES_BEHIND + RING_STAGES;
    if (threadIdx.x == 0u && turn >= STAGES_BEHIND && ahead < count) {
      memory.released[ahead % RING_STAGES].wait(ahead / RING_STAGES - 1u);
      fill(ahead);
    }
    __syncwarp();
  }
  __device__ const char* wait(uint turn) {
    memory.filled[turn % RING_STAGES].wait(turn / RING_STAGES);
    return memory.tiles[turn % RING_STAGES];
  }
  __device__ void release(uint turn, uint lane) {
    if (lane == 0u) memory.released[turn % RING_STAGES].arrive();
  }
};

}  // namespace spherepair
