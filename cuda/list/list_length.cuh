// SPDX-License-Identifier: MIT
// Where a row of the list begins, and whether there is room for it.
#pragma once

#include "cuda/list/list.cuh"

namespace spherepair {

// The length of the row; 0 if the columns have no room for it.
__device__ inline uint length_to_write(const KernelBuffers& buf, uint i) {
  uint length = buf.row_length[i];
  return buf.list_begin[i] + int64_t(length) > buf.list_state[0].room ? 0u : length;
}

__device__ inline uint64_t column_index(uint64_t at) { return at; }  // CUDA only: 64 bits

}  // namespace spherepair
