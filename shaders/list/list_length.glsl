// SPDX-License-Identifier: MIT
// Where a row of the list begins, how long it is, and whether there is room for all rows.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict readonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_BEGIN) restrict readonly buffer ListBeginBuffer { int64_t list_begin[]; };

// Whether the columns have room for all pairs; else none is written.
bool has_room() { return list_begin[list_state[0].looking] <= list_state[0].room; }

uint column_index(uint64_t at) { return uint(at); }  // GLSL only: indices have 32 bits
