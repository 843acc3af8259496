#version 450
// SPDX-License-Identifier: MIT
// One group per point or query with many neighbours, in turns until none is left: counts the pairs of its row.
#include "shaders/list/list_group.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict writeonly buffer RowLengthBuffer { uint row_length[]; };
layout(local_size_x = LIST_BLOCK) in;
shared uint found;

uint pairs_of(ListLook look) {
  float error = list_system[look.system].error;
  uint rows = rows_of(look);
  uint own = 0u;
  for (uint first = 0u; first < rows; first += LIST_BLOCK) {
    uint points = take_rows(look, first, rows);
    uint row = 0u;
    for (uint k = gl_LocalInvocationID.x; k < points; k += LIST_BLOCK) {
      row = row_from(row, k);
      own += uint(is_listed(look, error, row_begin[row] + k, row_shift[row], row_image[row]));
    }
    barrier();
  }
  return own;
}

void main() {
  if (list_state[0].dense == 0u || !is_right()) return;
  for (uint k = group_index(); k < list_state[0].looking; k += group_count()) {
    ListLook look = list_look[k];
    if (gl_LocalInvocationID.x == 0u) found = 0u;
    barrier();
    uint own = pairs_of(look);
    if (own != 0u) atomicAdd(found, own);
    barrier();
    if (gl_LocalInvocationID.x == 0u) row_length[look.i] = found;
    barrier();
  }
}
