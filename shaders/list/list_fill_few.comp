#version 450
// SPDX-License-Identifier: MIT
// One thread per point or query with few neighbours: writes its row of the list. A pair's place in the row is the
// number of smaller keys.
#include "shaders/list/list_columns.glsl"
#include "shaders/list/list_row.glsl"

layout(local_size_x = LIST_FEW_BLOCK) in;
shared uint64_t keys[LIST_FEW * LIST_FEW_BLOCK];

void main() {
  uint thread = gl_LocalInvocationID.x;
  uint k = group_index() * LIST_FEW_BLOCK + thread;
  if (k >= list_state[0].looking || !is_right() || list_state[0].dense != 0u) return;
  ListLook look = list_look[k];
  uint length = length_to_write(look.i);
  if (length == 0u || length > LIST_FEW) return;
  float error = list_system[look.system].error;
  uint found = 0u;
  uint rows = rows_of(look);
  for (uint r = 0u; r < rows; ++r) {
    CellRow row = row_at(look, r);
    for (uint at = row.begin; at < row.end; ++at) {
      if (!is_listed(look, error, at, row.shift, row.image) || found == length) continue;
      keys[found * LIST_FEW_BLOCK + thread] = list_key(id[at], row.image.x, row.image.y, row.image.z);
      ++found;
    }
  }
  for (uint n = 0u; n < found; ++n) {
    uint64_t key = keys[n * LIST_FEW_BLOCK + thread];
    uint rank = 0u;
    for (uint m = 0u; m < found; ++m) rank += uint(keys[m * LIST_FEW_BLOCK + thread] < key);
    write_pair(look.i, uint64_t(list_begin[look.i]) + uint64_t(rank), key);
  }
}
