// SPDX-License-Identifier: MIT
// How a group finds the pairs of one point: each thread takes a row of cells, then the group tests the points of all
// these rows together.
#pragma once

#include "cuda/list/list_row.cuh"

namespace spherepair {

__shared__ uint row_end[LIST_BLOCK];    // prefix sums of the rows' lengths
__shared__ uint row_begin[LIST_BLOCK];  // binned index of a row's k-th point, less k
__shared__ vec4 row_shift[LIST_BLOCK];
__shared__ ivec4 row_image[LIST_BLOCK];

// The next rows, one a thread; the number of their points.
__device__ inline uint take_rows(const KernelBuffers& buf, ListLook look, uint first, uint rows) {
  uint thread = threadIdx.x;
  uint length = 0u;
  uint begin = 0u;
  if (first + thread < rows) {
    CellRow row = row_at(buf, look, first + thread);
    begin = row.begin;
    length = row.end - begin;
    row_shift[thread] = row.shift;
    row_image[thread] = row.image;
  }
  uint end = length;
  for (uint step = 1u; step < LIST_BLOCK; step *= 2u) {
    row_end[thread] = end;
    __syncthreads();
    if (thread >= step) end += row_end[thread - step];
    __syncthreads();
  }
  row_end[thread] = end;
  row_begin[thread] = begin + length - end;
  __syncthreads();
  return row_end[LIST_BLOCK - 1u];
}

// The row of the k-th of these points, at the given one or behind it.
__device__ inline uint row_from(uint row, uint k) {
  while (row_end[row] <= k) ++row;
  return row;
}

}  // namespace spherepair
