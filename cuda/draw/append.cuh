// SPDX-License-Identifier: MIT
// Appends to a list in global memory, with one atomic per group.
#pragma once

#include "cuda/draw/visibility_buffer.cuh"

namespace spherepair {

// Returns the index of a new entry in the list whose length is in `word` of SLOT_DRAWN. Only threads with `appends` get
// one. All threads of the group must call it.
__device__ inline uint append_index(const KernelBuffers& buf, uint word, bool appends) {
  __shared__ uint entries;  // of the group
  __shared__ uint first_entry;
  if (threadIdx.x == 0u) entries = 0u;
  __syncthreads();
  uint own = appends ? atomicAdd(&entries, 1u) : 0u;
  __syncthreads();
  if (threadIdx.x == 0u && entries > 0u) first_entry = atomicAdd(&buf.drawn[word], entries);
  __syncthreads();
  return first_entry + own;
}

}  // namespace spherepair
