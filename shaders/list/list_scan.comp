#version 450
// SPDX-License-Identifier: MIT
// One group per tile of rows: lengths become begins by an exclusive prefix sum of the tile, plus the sums of the tiles
// before it.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict readonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_SUM) restrict readonly buffer ListSumBuffer { uint64_t list_sum[]; };
layout(std430, binding = SLOT_LIST_BEGIN) restrict writeonly buffer ListBeginBuffer { int64_t list_begin[]; };
layout(local_size_x = BLOCK) in;
shared uint64_t sums[BLOCK];

// Of all threads up to this one.
uint64_t sum_up_to(uint lane, uint64_t own) {
  for (uint step = 1u; step < BLOCK; step *= 2u) {
    sums[lane] = own;
    barrier();
    if (lane >= step) own += sums[lane - step];
    barrier();
  }
  sums[lane] = own;
  barrier();
  return own;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint looking = list_state[0].looking;
  if (group_index() * LIST_TILE >= looking) return;
  uint64_t before = uint64_t(0u);
  if (group_index() != 0u) {
    uint64_t share = uint64_t(0u);
    for (uint tile = lane; tile < group_index(); tile += BLOCK) share += list_sum[tile];
    sum_up_to(lane, share);
    before = sums[BLOCK - 1u];
    barrier();
  }
  uint first = group_index() * LIST_TILE + lane * (LIST_TILE / BLOCK);
  uint end = min(first + LIST_TILE / BLOCK, looking);
  uint64_t own = uint64_t(0u);
  for (uint i = first; i < end; ++i) own += uint64_t(row_length[i]);
  uint64_t begin = before + sum_up_to(lane, own) - own;
  for (uint i = first; i < end; ++i) {
    list_begin[i] = int64_t(begin);
    begin += uint64_t(row_length[i]);
    if (i + 1u == looking) list_begin[looking] = int64_t(begin);
  }
}
