#version 450
// SPDX-License-Identifier: MIT
// The groups of list_count with long rows once more: rows whose keys it had no room for write them.
#include "shaders/list/list_length.glsl"
#include "shaders/list/list_row.glsl"

layout(std430, binding = SLOT_LIST_LONG) restrict readonly buffer ListLongBuffer { uint list_long[]; };
layout(local_size_x = BLOCK) in;

void main() {
  if (!is_right() || !has_room()) return;
  for (uint group = group_index(); group < list_state[0].longer; group += LIST_LONG_GROUPS) {
    uint first = list_long[group] << list_state[0].row_bits;
    uint k = first + lane_of_row();
    bool looks = k < list_state[0].looking;
    uint i = list_look[looks ? k : first].i;
    KeyRange row;
    row.count = row_length[i];
    row.first = keys_at(i, row.count);
    found[lane_of_row()] = 0u;
    find_pairs(k, looks && row.count > list_state[0].kept, false, first, row);
  }
}
