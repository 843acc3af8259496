// SPDX-License-Identifier: MIT
// One group per tile of rows: lengths become begins by an exclusive prefix sum of the tile, plus the sums of the tiles
// before it.
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SCAN_BLOCK;
__shared__ uint64_t sums[BLOCK];

// Of all threads up to this one.
__device__ inline uint64_t sum_up_to(uint lane, uint64_t own) {
  for (uint step = 1u; step < BLOCK; step *= 2u) {
    sums[lane] = own;
    __syncthreads();
    if (lane >= step) own += sums[lane - step];
    __syncthreads();
  }
  sums[lane] = own;
  __syncthreads();
  return own;
}

__global__ void __launch_bounds__(BLOCK) list_scan(Params p, KernelBuffers buf) {
  wait_first(p);  // CUDA only: it gets ready early
  uint lane = threadIdx.x;
  uint looking = buf.list_state[0].looking;
  if (group_index(p) * LIST_TILE >= looking) return;
  uint64_t before = uint64_t(0u);
  if (group_index(p) != 0u) {
    uint64_t share = uint64_t(0u);
    for (uint tile = lane; tile < group_index(p); tile += BLOCK) share += buf.list_sum[tile];
    sum_up_to(lane, share);
    before = sums[BLOCK - 1u];
    __syncthreads();
  }
  uint first = group_index(p) * LIST_TILE + lane * (LIST_TILE / BLOCK);
  uint end = min(first + LIST_TILE / BLOCK, looking);
  uint64_t own = uint64_t(0u);
  for (uint i = first; i < end; ++i) own += uint64_t(buf.row_length[i]);
  uint64_t begin = before + sum_up_to(lane, own) - own;
  for (uint i = first; i < end; ++i) {
    buf.list_begin[i] = int64_t(begin);
    begin += uint64_t(buf.row_length[i]);
    if (i + 1u == looking) buf.list_begin[looking] = int64_t(begin);
  }
}

Entry list_scan_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_scan); }

}  // namespace spherepair
