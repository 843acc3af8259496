#version 450
// SPDX-License-Identifier: MIT
// One thread per element: writes a point, wrapped and scaled, to the next index of its cell, and what a point or a
// query looks through. The slot after a cell's own is the write cursor, and so, in the end, the begin of the next cell.
#include "shaders/list/list.glsl"

layout(std430, binding = SLOT_CELL) restrict buffer CellBuffer { uint cell[]; };
layout(std430, binding = SLOT_ID) restrict writeonly buffer IdBuffer { uint id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_LIST_LOOK) restrict writeonly buffer ListLookBuffer { ListLook list_look[]; };
layout(local_size_x = BLOCK) in;

// The first and the last cell of the reach along an axis.
ivec2 cells_within(uint element, uint s, uint k) {
  EXACT double at = wrapped_coordinate(element, k) - list_system[s].low[k];
  EXACT double span = (list_system[s].reach + list_given[element].w) * list_system[s].span[k] + list_system[s].slack[k];
  EXACT double low = (at - span) * list_system[s].cells_per_unit[k];
  EXACT double high = (at + span) * list_system[s].cells_per_unit[k];
  if ((list_system[s].periodic >> k & 1u) == 0u) {
    double cells = double(list_system[s].cells[k]);
    EXACT double last = cells - double(1.0f);
    if (high < double(0.0f) || low >= cells) return ivec2(0, -1);
    low = low < double(0.0f) ? double(0.0f) : low;
    high = high > last ? last : high;
  }
  return ivec2(floor_of(low), floor_of(high));
}

void write_look(uint k, uint i, uint element, vec4 place) {
  uint s = uint(list_place[element].w);
  ivec2 x = cells_within(element, s, 0u);
  ivec2 y = cells_within(element, s, 1u);
  ivec2 z = cells_within(element, s, 2u);
  EXACT double reach = (list_state[0].cutoff + list_state[0].skin + list_given[element].w) * list_system[s].scale;
  place.w = float(reach);
  list_look[k] = ListLook(place, x.x, y.x, z.x, x.y, y.y, z.y, i, s);
}

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= list_state[0].points + list_state[0].queries) return;
  if ((list_state[0].wrong | list_state[0].far | list_state[0].wide) != 0u) return;
  EXACT double radius = list_given[i].w * list_system[list_place[i].w].scale;
  vec4 place = vec4(place_along(i, 0u), place_along(i, 1u), place_along(i, 2u), float(radius));
  if (i >= list_state[0].points) {
    write_look(i - list_state[0].points, i - list_state[0].points, i, place);
    return;
  }
  uint at = atomicAdd(cell[cell_of(i) + 1u], 1u);
  sorted[at] = place;
  id[at] = i;
  if (!has_flag(LIST_ASKS)) write_look(at, i, i, place);
}
