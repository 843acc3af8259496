#version 450
// SPDX-License-Identifier: MIT
// One thread per point: counts it in the slot behind its cell, where the prefix sums then leave the begin of the cell
// and list_scatter that of the next.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_CELL) restrict buffer CellBuffer { uint cell[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i < list_state[0].points) atomicAdd(cell[cell_of(i) + 1u], 1u);
}
