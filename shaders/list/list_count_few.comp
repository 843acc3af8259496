#version 450
// SPDX-License-Identifier: MIT
// One thread per point or query with few neighbours: counts the pairs of its row.
#include "shaders/list/list_row.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict writeonly buffer RowLengthBuffer { uint row_length[]; };
layout(local_size_x = LIST_FEW_BLOCK) in;

void main() {
  uint k = group_index() * LIST_FEW_BLOCK + gl_LocalInvocationID.x;
  if (k >= list_state[0].looking || !is_right() || list_state[0].dense != 0u) return;
  ListLook look = list_look[k];
  float error = list_system[look.system].error;
  uint length = 0u;
  uint rows = rows_of(look);
  for (uint r = 0u; r < rows; ++r) {
    CellRow row = row_at(look, r);
    for (uint at = row.begin; at < row.end; ++at) length += uint(is_listed(look, error, at, row.shift, row.image));
  }
  row_length[look.i] = length;
  if (length > LIST_FEW) atomicMax(list_state[0].longest, length);
}
