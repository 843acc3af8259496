#version 450
// SPDX-License-Identifier: MIT
// One thread per slot of the cells, and at least one for every extreme: all 0, and nothing found yet.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_CELL) restrict writeonly buffer CellBuffer { uint cell[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i < p.sort.scan_tiles * SCAN_TILE) cell[i] = 0u;
  if (i / LIST_EXTREMES < list_state[0].systems) list_system[i / LIST_EXTREMES].extreme[i % LIST_EXTREMES] = 0u;
  if (i != 0u) return;
  list_state[0].wrong = 0u;
  list_state[0].far = 0u;
  list_state[0].wide = 0u;
  list_state[0].longer = 0u;
}
