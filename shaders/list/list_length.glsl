// SPDX-License-Identifier: MIT
// Where a row of the list begins, how long it is, where its keys lie, and whether there is room for all rows.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict readonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_BEGIN) restrict readonly buffer ListBeginBuffer { int64_t list_begin[]; };

// Whether the columns have room for all pairs; else none is written.
bool has_room() { return list_begin[list_state[0].looking] <= list_state[0].room; }

// Where the keys of a row lie: where list_count kept them, or where list_find wrote them if they were too many, behind
// those of all rows.
uint64_t keys_at(uint i, uint length) {
  uint64_t kept = uint64_t(list_state[0].kept);
  if (uint64_t(length) <= kept) return uint64_t(i) * kept;
  return uint64_t(list_state[0].looking) * kept + uint64_t(list_begin[i]);
}
