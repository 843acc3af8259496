// SPDX-License-Identifier: MIT
// Places in a list, for which the groups queue once each.
#pragma once

#include "cuda/draw/visible.cuh"

namespace spherepair {

// The place in the list whose entries `word` of SLOT_DRAWN counts, for a thread that takes one. All threads of the
// group call it.
__device__ inline uint index_in_list(const KernelBuffers& w, uint word, bool takes) {
  __shared__ uint entries;  // of the group
  __shared__ uint first_entry;
  if (threadIdx.x == 0u) entries = 0u;
  __syncthreads();
  uint sorted_index = takes ? atomicAdd(&entries, 1u) : 0u;
  __syncthreads();
  if (threadIdx.x == 0u && entries > 0u) first_entry = atomicAdd(&w.drawn[word], entries);
  __syncthreads();
  return first_entry + sorted_index;
}

}  // namespace spherepair
