// SPDX-License-Identifier: MIT
// Writes the columns of a pair.
#pragma once

#include "cuda/list/list_row.cuh"

namespace spherepair {

// The length of the row; 0 if the columns have no room for it.
__device__ inline uint length_to_write(const KernelBuffers& buf, uint i) {
  uint length = buf.row_length[i];
  return buf.list_begin[i] + int64_t(length) > buf.list_state[0].room ? 0u : length;
}

__device__ inline uint64_t column_index(uint64_t at) { return at; }  // CUDA only: 64 bits

__device__ inline void write_pair(const KernelBuffers& buf, uint i, uint64_t at, uint64_t key) {
  uint j = point_of_key(key);
  if (has_flag(buf, LIST_WANTS_FIRST)) buf.list_first[column_index(at)] = i;
  if (has_flag(buf, LIST_WANTS_SECOND)) buf.list_second[column_index(at)] = j;
  if (!has_flag(buf, LIST_WANTS_SHIFTS)) return;
  ivec4 mine = buf.list_place[element_of(buf, i)];
  ivec4 other = buf.list_place[j];
  buf.list_shift[3u * column_index(at)] = image_of_key(key, 0u) + mine.x - other.x;
  buf.list_shift[3u * column_index(at) + 1u] = image_of_key(key, 1u) + mine.y - other.y;
  buf.list_shift[3u * column_index(at) + 2u] = image_of_key(key, 2u) + mine.z - other.z;
}

}  // namespace spherepair
