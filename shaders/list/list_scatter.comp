#version 450
// SPDX-License-Identifier: MIT
// One thread per point: writes its index to its place in its cell.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_CELL) restrict readonly buffer CellBuffer { uint cell[]; };
layout(std430, binding = SLOT_LIST_BIN) restrict readonly buffer ListBinBuffer { uvec2 list_bins[]; };
layout(std430, binding = SLOT_ID) restrict writeonly buffer IdBuffer { uint id[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= list_state[0].points) return;
  uvec2 own = list_bins[i];
  id[cell[own.x] + own.y] = i;
}
