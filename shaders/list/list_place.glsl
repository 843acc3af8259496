// SPDX-License-Identifier: MIT
// Where a point lies, wrapped and scaled, and what it looks through.
#include "shaders/list/list.glsl"

vec4 place_of(uint element) {
  EXACT double radius = list_given[element].w * list_system[list_place[element].w].scale;
  return vec4(place_along(element, 0u), place_along(element, 1u), place_along(element, 2u), float(radius));
}

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

ListLook look_of(uint i, uint element) {
  uint s = uint(list_place[element].w);
  ListLook look;
  for (uint k = 0u; k < 3u; ++k) {
    ivec2 cells = cells_within(element, s, k);
    look.low[k] = cells.x;
    look.high[k] = cells.y + 1;
  }
  look.i = i;
  look.system = s;
  return look;
}
