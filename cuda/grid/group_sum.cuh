// SPDX-License-Identifier: MIT
// Prefix sums over the threads of a group, through registers within each subgroup.
#pragma once

#include "common/shared/layout.h"

namespace spherepair {

// Returns the inclusive prefix sum of `own`. Every thread of the group must call it, with a barrier between two calls.
// CUDA only from here: shuffles within a warp, which has 32 threads
template <uint BLOCK>
__device__ inline uint sum_up_to(uint own) {
  __shared__ uint warp_sums[BLOCK / 32u];
  uint lane = threadIdx.x % 32u;
  uint warp = threadIdx.x / 32u;
  uint upto = own;
  for (uint distance = 1u; distance < 32u; distance *= 2u) {
    uint other = __shfl_up_sync(~0u, upto, distance);
    if (lane >= distance) upto += other;
  }
  if (lane == 31u) warp_sums[warp] = upto;
  __syncthreads();
  uint before = lane < warp ? warp_sums[lane] : 0u;
#if __CUDA_ARCH__ >= 800
  before = __reduce_add_sync(~0u, before);
#else
  for (uint bit = 1u; bit < 32u; bit *= 2u) before += __shfl_xor_sync(~0u, before, bit);
#endif
  return before + upto;
}
// until here

}  // namespace spherepair
