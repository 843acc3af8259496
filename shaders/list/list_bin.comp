#version 450
// SPDX-License-Identifier: MIT
// One thread per point: adds it to the count of its cell, and stores the cell and the point's place in it.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_CELL) restrict buffer CellBuffer { uint cell[]; };
layout(std430, binding = SLOT_LIST_BIN) restrict writeonly buffer ListBinBuffer { uvec2 list_bins[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= list_state[0].points) return;
  uint own = cell_of(i);
  list_bins[i] = uvec2(own, atomicAdd(cell[own], 1u));
}
