// SPDX-License-Identifier: MIT
// Where a row of the list begins, and whether there is room for it.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict readonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_BEGIN) restrict readonly buffer ListBeginBuffer { int64_t list_begin[]; };

// The length of the row; 0 if the columns have no room for it.
uint length_to_write(uint i) {
  uint length = row_length[i];
  return list_begin[i] + int64_t(length) > list_state[0].room ? 0u : length;
}

uint column_index(uint64_t at) { return uint(at); }  // GLSL only: indices have 32 bits
