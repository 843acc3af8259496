// SPDX-License-Identifier: MIT
// Joins the boxes of parts into the box of all centres, with the greatest radius in high.w.
#pragma once

#include "cuda/kernels.cuh"

namespace spherepair {

// CUDA only from here: references to shared memory
__device__ inline void widen(vec4& low, vec4& high, vec4 other_low, vec4 other_high) {
  low = vec4{smaller(other_low.x, low.x), smaller(other_low.y, low.y), smaller(other_low.z, low.z), 0.0f};
  high = vec4{larger(other_high.x, high.x), larger(other_high.y, high.y), larger(other_high.z, high.z),
              larger(other_high.w, high.w)};
}

// Reduces COUNT boxes in shared memory, a power of two, to the first. Every thread of the group calls it.
template <uint COUNT>
__device__ inline void widen_first(vec4* low, vec4* high) {
  for (uint half = COUNT / 2u; half > 0u; half /= 2u) {
    __syncthreads();
    uint k = threadIdx.x;
    if (k < half) widen(low[k], high[k], low[k + half], high[k + half]);
  }
  __syncthreads();
}
// until here

}  // namespace spherepair
