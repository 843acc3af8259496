#version 450
// SPDX-License-Identifier: MIT
// One group per tile of rows: the sum of their lengths, for list_scan.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict readonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_SUM) restrict writeonly buffer ListSumBuffer { uint64_t list_sum[]; };
layout(local_size_x = BLOCK) in;
shared uint64_t sums[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * LIST_TILE;
  if (first >= list_state[0].looking) return;
  uint64_t own = uint64_t(0u);
  uint end = min(first + LIST_TILE, list_state[0].looking);
  for (uint i = first + lane; i < end; i += BLOCK) own += uint64_t(row_length[i]);
  sums[lane] = own;
  barrier();
  for (uint step = BLOCK / 2u; step != 0u; step /= 2u) {
    if (lane < step) sums[lane] += sums[lane + step];
    barrier();
  }
  if (lane == 0u) list_sum[group_index()] = sums[0];
}
