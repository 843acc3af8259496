#version 450
// SPDX-License-Identifier: MIT
// One thread per point, then per query: writes it, wrapped and scaled, and what it looks through. A point goes to its
// place in its cell.
#include "shaders/list/list_place.glsl"

layout(std430, binding = SLOT_CELL) restrict readonly buffer CellBuffer { uint cell[]; };
layout(std430, binding = SLOT_LIST_BIN) restrict readonly buffer ListBinBuffer { uvec2 list_bins[]; };
layout(std430, binding = SLOT_ID) restrict writeonly buffer IdBuffer { uint id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_LIST_LOOK) restrict writeonly buffer ListLookBuffer { ListLook list_look[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint element = group_index() * BLOCK + gl_LocalInvocationID.x;
  uint points = list_state[0].points;
  if (element >= points + list_state[0].queries || !is_right()) return;
  vec4 place = place_of(element);
  if (element >= points) {
    sorted[element] = place;
    list_look[element - points] = look_of(element - points, element);
  } else {
    uvec2 bin = list_bins[element];
    uint at = cell[bin.x] + bin.y;
    id[at] = element;
    sorted[at] = place;
    if (!has_flag(LIST_ASKS)) list_look[at] = look_of(element, element);
  }
}
