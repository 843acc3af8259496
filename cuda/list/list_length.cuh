// SPDX-License-Identifier: MIT
// Where a row of the list begins, how long it is, and whether there is room for all rows.
#pragma once

#include "cuda/list/list.cuh"

namespace spherepair {

// Whether the columns have room for all pairs; else none is written.
__device__ inline bool has_room(const KernelBuffers& buf) {
  return buf.list_begin[buf.list_state[0].looking] <= buf.list_state[0].room;
}

__device__ inline uint64_t column_index(uint64_t at) { return at; }  // CUDA only: 64 bits

}  // namespace spherepair
