#version 450
// SPDX-License-Identifier: MIT
// One thread per row of the list, or several where there are few rows: counts its pairs, and keeps their keys.
#include "shaders/list/list_row.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict writeonly buffer RowLengthBuffer { uint row_length[]; };
layout(local_size_x = LIST_BLOCK) in;

void main() {
  if (!is_right()) return;
  uint thread = gl_LocalInvocationID.x;
  uint bits = list_state[0].row_bits;
  uint k = (group_index() * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  uint lane = thread & (lanes - 1u);
  bool looks = k < list_state[0].looking;
  found[thread] = 0u;
  barrier();
  if (looks) {
    KeyRange kept;
    kept.first = uint64_t(list_look[k].i) * uint64_t(list_state[0].kept);
    kept.count = list_state[0].kept;
    find_pairs(list_look[k], lane, lanes, kept, thread >> bits);
  }
  barrier();
  if (looks && lane == 0u) row_length[list_look[k].i] = found[thread >> bits];
}
