// SPDX-License-Identifier: MIT
// Wraps a point into its system's box, and adds it to the extremes of the system. Those of one system are added up by
// the threads, then in shared memory.
#include "shaders/list/list.glsl"

shared uint extreme[LIST_EXTREMES];
shared uint group_system;

struct Extremes {
  uint of[LIST_EXTREMES];
};

Extremes no_extremes() {
  Extremes none;
  for (uint which = 0u; which < LIST_EXTREMES; ++which) none.of[which] = 0u;
  return none;
}

Extremes noted(Extremes own, uint s, uint which, uint value) {
  if (s == group_system) {
    own.of[which] = max(own.of[which], value);
  } else if (value != 0u) {
    atomicMax(list_system[s].extreme[which], value);
  }
  return own;
}

// Returns by how many boxes a point is wrapped along an axis; 0 if the axis is not periodic.
int boxes_along(uint i, uint s, uint k) {
  if ((list_system[s].periodic >> k & 1u) == 0u) return 0;
  double at = list_coordinate(list_system[s].dual, k, list_given[i]);
  if (magnitude(at) < double(1073741824.0f)) return floor_of(at);
  atomicMax(list_state[0].far, ~i);
  return 0;
}

Extremes measured(Extremes own, uint i, uint s) {
  dvec4 x = list_given[i];
  bool point = i < list_state[0].points;
  list_place[i] = ivec4(0, 0, 0, int(s));
  if (!(is_listed_number(x.x) && is_listed_number(x.y) && is_listed_number(x.z) && is_listed_number(x.w)) ||
      x.w < double(0.0f)) {
    atomicMax(list_state[0].wrong, ~i);
    return own;
  }
  ivec4 boxes = ivec4(boxes_along(i, s, 0u), boxes_along(i, s, 1u), boxes_along(i, s, 2u), int(s));
  list_place[i] = boxes;
  own = noted(own, s, LIST_CELLS, uint(max(boxes.x, -boxes.x)));
  own = noted(own, s, LIST_CELLS + 1u, uint(max(boxes.y, -boxes.y)));
  own = noted(own, s, LIST_CELLS + 2u, uint(max(boxes.z, -boxes.z)));
  for (uint k = 0u; k < 3u; ++k) {
    if (!point || (list_system[s].periodic >> k & 1u) != 0u) continue;
    uint at = ordered_high(list_coordinate(list_system[s].dual, k, x));
    own = noted(own, s, LIST_LOW + k, ~at);
    own = noted(own, s, LIST_HIGH + k, at);
  }
  uint size = max(ordered_high(magnitude(x.x)), max(ordered_high(magnitude(x.y)), ordered_high(magnitude(x.z))));
  own = noted(own, s, LIST_LARGEST, size);
  if (point) own = noted(own, s, LIST_RADIUS, ordered_high(x.w));
  if (!point || !has_flag(LIST_ASKS)) own = noted(own, s, LIST_LOOKING_RADIUS, ordered_high(x.w));
  return own;
}

void add_up(Extremes own) {
  for (uint which = 0u; which < LIST_EXTREMES; ++which)
    if (own.of[which] != 0u) atomicMax(extreme[which], own.of[which]);
}
