// SPDX-License-Identifier: MIT
// How a group finds the pairs of one point: each thread takes a row of cells, then the group tests the points of all
// these rows together.
#include "shaders/list/list_row.glsl"

shared uint row_end[LIST_BLOCK];    // prefix sums of the rows' lengths
shared uint row_begin[LIST_BLOCK];  // binned index of a row's k-th point, less k
shared vec4 row_shift[LIST_BLOCK];
shared ivec4 row_image[LIST_BLOCK];

// The next rows, one a thread; the number of their points.
uint take_rows(ListLook look, uint first, uint rows) {
  uint thread = gl_LocalInvocationID.x;
  uint length = 0u;
  uint begin = 0u;
  if (first + thread < rows) {
    CellRow row = row_at(look, first + thread);
    begin = row.begin;
    length = row.end - begin;
    row_shift[thread] = row.shift;
    row_image[thread] = row.image;
  }
  uint end = length;
  for (uint step = 1u; step < LIST_BLOCK; step *= 2u) {
    row_end[thread] = end;
    barrier();
    if (thread >= step) end += row_end[thread - step];
    barrier();
  }
  row_end[thread] = end;
  row_begin[thread] = begin + length - end;
  barrier();
  return row_end[LIST_BLOCK - 1u];
}

// The row of the k-th of these points, at the given one or behind it.
uint row_from(uint row, uint k) {
  while (row_end[row] <= k) ++row;
  return row;
}
