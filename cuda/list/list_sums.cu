// SPDX-License-Identifier: MIT
// One group per tile of rows: the sum of their lengths, for list_scan.
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SCAN_BLOCK;
__shared__ uint64_t sums[BLOCK];

__global__ void __launch_bounds__(BLOCK) list_sums(Params p, KernelBuffers buf) {
  wait_first(p);  // CUDA only: it gets ready early
  uint lane = threadIdx.x;
  uint first = group_index(p) * LIST_TILE;
  if (first >= buf.list_state[0].looking) return;
  uint64_t own = uint64_t(0u);
  uint end = min(first + LIST_TILE, buf.list_state[0].looking);
  for (uint i = first + lane; i < end; i += BLOCK) own += uint64_t(buf.row_length[i]);
  sums[lane] = own;
  __syncthreads();
  for (uint step = BLOCK / 2u; step != 0u; step /= 2u) {
    if (lane < step) sums[lane] += sums[lane + step];
    __syncthreads();
  }
  if (lane == 0u) buf.list_sum[group_index(p)] = sums[0];
}

Entry list_sums_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_sums); }

}  // namespace spherepair
