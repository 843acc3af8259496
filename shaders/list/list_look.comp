#version 450
// SPDX-License-Identifier: MIT
// One thread per binned point, then per query: writes the point, wrapped and scaled, and what it looks through.
#include "shaders/list/list_place.glsl"

layout(std430, binding = SLOT_ID) restrict readonly buffer IdBuffer { uint id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_LIST_LOOK) restrict writeonly buffer ListLookBuffer { ListLook list_look[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  uint points = list_state[0].points;
  if (k >= points + list_state[0].queries || !is_right()) return;
  uint element = k < points ? id[k] : k;
  uint i = element - (k < points ? 0u : points);
  vec4 place = place_of(element);
  ListLook look = look_of(i, element);
  sorted[k] = place;
  if (k >= points) {
    list_look[i] = look;
  } else if (!has_flag(LIST_ASKS)) {
    list_look[k] = look;
  }
}
