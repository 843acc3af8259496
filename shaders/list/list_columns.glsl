// SPDX-License-Identifier: MIT
// Writes the columns of a pair.
#include "shaders/list/list_row.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict readonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_BEGIN) restrict readonly buffer ListBeginBuffer { int64_t list_begin[]; };
layout(std430, binding = SLOT_LIST_FIRST) restrict writeonly buffer ListFirstBuffer { uint list_first[]; };
layout(std430, binding = SLOT_LIST_SECOND) restrict writeonly buffer ListSecondBuffer { uint list_second[]; };
layout(std430, binding = SLOT_LIST_SHIFT) restrict writeonly buffer ListShiftBuffer { int list_shift[]; };

// The length of the row; 0 if the columns have no room for it.
uint length_to_write(uint i) {
  uint length = row_length[i];
  return list_begin[i] + int64_t(length) > list_state[0].room ? 0u : length;
}

uint column_index(uint64_t at) { return uint(at); }  // GLSL only: indices have 32 bits

void write_pair(uint i, uint64_t at, uint64_t key) {
  uint j = point_of_key(key);
  if (has_flag(LIST_WANTS_FIRST)) list_first[column_index(at)] = i;
  if (has_flag(LIST_WANTS_SECOND)) list_second[column_index(at)] = j;
  if (!has_flag(LIST_WANTS_SHIFTS)) return;
  ivec4 mine = list_place[element_of(i)];
  ivec4 other = list_place[j];
  list_shift[3u * column_index(at)] = image_of_key(key, 0u) + mine.x - other.x;
  list_shift[3u * column_index(at) + 1u] = image_of_key(key, 1u) + mine.y - other.y;
  list_shift[3u * column_index(at) + 2u] = image_of_key(key, 2u) + mine.z - other.z;
}
