#version 450
// SPDX-License-Identifier: MIT
// One group per 2^row_bits rows of the list: counts their pairs, and keeps their keys.
#include "shaders/list/list_row.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict writeonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_LONG) restrict writeonly buffer ListLongBuffer { uint list_long[]; };
layout(local_size_x = BLOCK) in;

shared uint is_long;  // not 0: a row of the group has more keys than are kept

void main() {
  uint first = group_index() << list_state[0].row_bits;
  if (!is_right() || first >= list_state[0].looking) return;
  uint k = first + lane_of_row();
  bool looks = k < list_state[0].looking;
  uint i = list_look[looks ? k : first].i;
  KeyRange kept;
  kept.count = list_state[0].kept;
  kept.first = uint64_t(i) * uint64_t(kept.count);
  found[lane_of_row()] = 0u;
  is_long = 0u;
  find_pairs(k, looks, LONG_ROWS, first, kept);
  if (looks && gl_LocalInvocationID.x < group_rows()) {
    uint length = found[lane_of_row()];
    row_length[i] = length;
    if (length > kept.count && atomicMax(is_long, 1u) == 0u)
      list_long[atomicAdd(list_state[0].longer, 1u)] = group_index();
  }
}
