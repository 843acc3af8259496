// SPDX-License-Identifier: MIT
// What the kernels of lists share: their buffers, and where a point lies. Elements are the points, then the queries.
#define ONLY_GROUPS
#include "shaders/kernels.glsl"
#include "common/shared/list.h"

#ifndef LIST_ACCESS
#define LIST_ACCESS
#endif
layout(std430, binding = SLOT_LIST_STATE) restrict buffer ListStateBuffer { ListState list_state[]; };
layout(std430, binding = SLOT_LIST_SYSTEM) restrict LIST_ACCESS buffer ListSystemBuffer { ListSystem list_system[]; };
layout(std430, binding = SLOT_LIST_GIVEN) restrict readonly buffer ListGivenBuffer { dvec4 list_given[]; };
layout(std430, binding = SLOT_LIST_PLACE) restrict buffer ListPlaceBuffer { ivec4 list_place[]; };

// Whether no invalid number, no point too far away and no reach too long was found.
bool is_right() { return (list_state[0].wrong | list_state[0].far | list_state[0].wide) == 0u; }

bool has_flag(uint flag) { return (list_state[0].flags & flag) != 0u; }

// The last system that begins at the element or before it, and is not empty.
uint system_of(uint i) {
  bool query = i >= list_state[0].points;
  uint low = 0u;
  uint high = list_state[0].systems;
  while (high - low > 1u) {
    uint middle = (low + high) / 2u;
    uint first = query ? list_state[0].points + list_system[middle].first_query : list_system[middle].first_point;
    if (first <= i) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

// The element of the i-th that looks.
uint element_of(uint i) { return has_flag(LIST_ASKS) ? list_state[0].points + i : i; }

uint column_index(uint64_t at) { return uint(at); }  // GLSL only: indices have 32 bits

// Numbers of images within reach, in order: to either side of a system, along two axes, and that of no image.
struct Images {
  ivec4 most;
  uint along_y, along_z, none;
};
Images images_of(uint s) {
  Images images;
  images.most = ivec4(int(list_system[s].images[0]), int(list_system[s].images[1]), int(list_system[s].images[2]), 0);
  images.along_y = 2u * uint(images.most.y) + 1u;
  images.along_z = 2u * uint(images.most.z) + 1u;
  images.none = (uint(images.most.x) * images.along_y + uint(images.most.y)) * images.along_z + uint(images.most.z);
  return images;
}
uint number_of_image(Images images, ivec4 image) {
  uint x_and_y = uint(image.x + images.most.x) * images.along_y + uint(image.y + images.most.y);
  return x_and_y * images.along_z + uint(image.z + images.most.z);
}
ivec4 image_of(Images images, uint number) {
  if (number == images.none) return ivec4(0, 0, 0, 0);
  uint x_and_y = number / images.along_z;
  uint x = x_and_y / images.along_y;
  return ivec4(int(x) - images.most.x, int(x_and_y - x * images.along_y) - images.most.y,
               int(number - x_and_y * images.along_z) - images.most.z, 0);
}

int floor_divide(int a, int b) {
  if (a >= 0 && a < b) return 0;  // nearly always, and quick
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

int floor_of(double x) {
  int below = int(x);
  return double(below) > x ? below - 1 : below;
}

// Coordinate k inside the box.
double wrapped_coordinate(uint i, uint k) {
  ivec4 place = list_place[i];
  int boxes = k == 0u ? place.x : k == 1u ? place.y : place.z;
  EXACT double at = list_coordinate(list_system[place.w].dual, k, list_given[i]) - double(boxes);
  return at;
}

uint cell_along(uint i, uint k) {
  uint s = uint(list_place[i].w);
  EXACT double at = (wrapped_coordinate(i, k) - list_system[s].low[k]) * list_system[s].cells_per_unit[k];
  return min(at > double(0.0f) ? uint(at) : 0u, list_system[s].cells[k] - 1u);
}
uint cell_of(uint i) {
  uint s = uint(list_place[i].w);
  uint row = cell_along(i, 2u) * list_system[s].cells[1] + cell_along(i, 1u);
  return list_system[s].first_cell + row * list_system[s].cells[0] + cell_along(i, 0u);
}

// The length of these boxes along an axis, scaled.
float scaled_boxes(uint s, ivec4 boxes, uint axis) {
  EXACT double moved = double(boxes.x) * list_system[s].row.of[axis] +
                       double(boxes.y) * list_system[s].row.of[3u + axis] +
                       double(boxes.z) * list_system[s].row.of[6u + axis];
  EXACT double scaled = moved * list_system[s].scale;
  return float(scaled);
}

float place_along(uint i, uint axis) {
  ivec4 place = list_place[i];
  uint s = uint(place.w);
  EXACT double along = component_of(list_given[i], axis) - double(place.x) * list_system[s].row.of[axis] -
                       double(place.y) * list_system[s].row.of[3u + axis] -
                       double(place.z) * list_system[s].row.of[6u + axis];
  EXACT double scaled = (along - list_system[s].origin[axis]) * list_system[s].scale;
  return float(scaled);
}
