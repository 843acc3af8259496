#version 450
// SPDX-License-Identifier: MIT
// The threads of list_count once more: those of rows whose keys it had no room for write them.
#include "shaders/list/list_length.glsl"
#include "shaders/list/list_row.glsl"

layout(local_size_x = LIST_BLOCK) in;

void main() {
  if (!is_right() || !has_room()) return;
  uint thread = gl_LocalInvocationID.x;
  uint bits = list_state[0].row_bits;
  uint k = (group_index() * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  found[thread] = 0u;
  barrier();
  if (k >= list_state[0].looking) return;
  uint i = list_look[k].i;
  KeyRange row;
  row.count = row_length[i];
  if (row.count <= list_state[0].kept) return;
  row.first = keys_at(i, row.count);
  find_pairs(list_look[k], thread & (lanes - 1u), lanes, row, thread >> bits);
}
