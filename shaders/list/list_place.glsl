// SPDX-License-Identifier: MIT
// Where a point lies, wrapped and scaled, and what it looks through.
#include "shaders/list/list.glsl"

vec4 place_of(uint element) {
  EXACT double radius = list_given[element].w * list_system[list_place[element].w].scale;
  return vec4(place_along(element, 0u), place_along(element, 1u), place_along(element, 2u), float(radius));
}

int floor_divide(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

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

ListLook look_of(uint i, uint element, uint self, vec4 place) {
  uint s = uint(list_place[element].w);
  ivec2 x = cells_within(element, s, 0u);
  ivec2 y = cells_within(element, s, 1u);
  ivec2 z = cells_within(element, s, 2u);
  int cells_x = int(list_system[s].cells[0]);
  int cells_y = int(list_system[s].cells[1]);
  int cells_z = int(list_system[s].cells[2]);
  EXACT double reach = (list_state[0].cutoff + list_state[0].skin + list_given[element].w) * list_system[s].scale;
  place.w = float(reach);
  ListLook look;
  look.place = place;
  look.image_x = floor_divide(x.x, cells_x);
  look.image_y = floor_divide(y.x, cells_y);
  look.image_z = floor_divide(z.x, cells_z);
  look.cell_x = uint(x.x - look.image_x * cells_x);
  look.cell_y = uint(y.x - look.image_y * cells_y);
  look.cell_z = uint(z.x - look.image_z * cells_z);
  bool none = x.y < x.x || y.y < y.x || z.y < z.x;
  look.along_x = uint(x.y - x.x + 1);
  look.along_y = none ? 1u : uint(y.y - y.x + 1);
  look.along_z = none ? 0u : uint(z.y - z.x + 1);
  look.i = i;
  look.system = s;
  look.self = self;
  return look;
}
