// SPDX-License-Identifier: MIT
// What the kernels of lists share: their buffers, and where a point lies. Elements are the points, then the queries.
#pragma once

#include "common/shared/list.h"
#include "cuda/kernels.cuh"

namespace spherepair {

// Whether no invalid number, no point too far away and no reach too long was found.
__device__ inline bool is_right(const KernelBuffers& buf) {
  return (buf.list_state[0].wrong | buf.list_state[0].far | buf.list_state[0].wide) == 0u;
}

__device__ inline bool has_flag(const KernelBuffers& buf, uint flag) { return (buf.list_state[0].flags & flag) != 0u; }

// The last system that begins at the element or before it, and is not empty.
__device__ inline uint system_of(const KernelBuffers& buf, uint i) {
  bool query = i >= buf.list_state[0].points;
  uint low = 0u;
  uint high = buf.list_state[0].systems;
  while (high - low > 1u) {
    uint middle = (low + high) / 2u;
    uint first =
        query ? buf.list_state[0].points + buf.list_system[middle].first_query : buf.list_system[middle].first_point;
    if (first <= i) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

// The element of the i-th that looks.
__device__ inline uint element_of(const KernelBuffers& buf, uint i) {
  return has_flag(buf, LIST_ASKS) ? buf.list_state[0].points + i : i;
}

__device__ inline uint64_t column_index(uint64_t at) { return at; }  // CUDA only: 64 bits

// Numbers of images within reach, in order: to either side of a system, along two axes, and that of no image.
struct Images {
  ivec4 most;
  uint along_y, along_z, none;
};
__device__ inline Images images_of(const KernelBuffers& buf, uint s) {
  Images images;
  images.most =
      ivec4{int(buf.list_system[s].images[0]), int(buf.list_system[s].images[1]), int(buf.list_system[s].images[2]), 0};
  images.along_y = 2u * uint(images.most.y) + 1u;
  images.along_z = 2u * uint(images.most.z) + 1u;
  images.none = (uint(images.most.x) * images.along_y + uint(images.most.y)) * images.along_z + uint(images.most.z);
  return images;
}
__device__ inline uint number_of_image(Images images, ivec4 image) {
  uint x_and_y = uint(image.x + images.most.x) * images.along_y + uint(image.y + images.most.y);
  return x_and_y * images.along_z + uint(image.z + images.most.z);
}
__device__ inline ivec4 image_of(Images images, uint number) {
  if (number == images.none) return ivec4{0, 0, 0, 0};
  uint x_and_y = number / images.along_z;
  uint x = x_and_y / images.along_y;
  return ivec4{int(x) - images.most.x, int(x_and_y - x * images.along_y) - images.most.y,
               int(number - x_and_y * images.along_z) - images.most.z, 0};
}

__device__ inline int floor_divide(int a, int b) {
  if (a >= 0 && a < b) return 0;  // nearly always, and quick
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

__device__ inline int floor_of(double x) {
  int below = int(x);
  return double(below) > x ? below - 1 : below;
}

// Coordinate k inside the box.
__device__ inline double wrapped_coordinate(const KernelBuffers& buf, uint i, uint k) {
  ivec4 place = buf.list_place[i];
  int boxes = k == 0u ? place.x : k == 1u ? place.y : place.z;
  EXACT double at = list_coordinate(buf.list_system[place.w].dual, k, buf.list_given[i]) - double(boxes);
  return at;
}

__device__ inline uint cell_along(const KernelBuffers& buf, uint i, uint k) {
  uint s = uint(buf.list_place[i].w);
  EXACT double at = (wrapped_coordinate(buf, i, k) - buf.list_system[s].low[k]) * buf.list_system[s].cells_per_unit[k];
  return min(at > double(0.0f) ? uint(at) : 0u, buf.list_system[s].cells[k] - 1u);
}
__device__ inline uint cell_of(const KernelBuffers& buf, uint i) {
  uint s = uint(buf.list_place[i].w);
  uint row = cell_along(buf, i, 2u) * buf.list_system[s].cells[1] + cell_along(buf, i, 1u);
  return buf.list_system[s].first_cell + row * buf.list_system[s].cells[0] + cell_along(buf, i, 0u);
}

// The length of these boxes along an axis, scaled.
__device__ inline float scaled_boxes(const KernelBuffers& buf, uint s, ivec4 boxes, uint axis) {
  EXACT double moved = double(boxes.x) * buf.list_system[s].row.of[axis] +
                       double(boxes.y) * buf.list_system[s].row.of[3u + axis] +
                       double(boxes.z) * buf.list_system[s].row.of[6u + axis];
  EXACT double scaled = moved * buf.list_system[s].scale;
  return float(scaled);
}

__device__ inline float place_along(const KernelBuffers& buf, uint i, uint axis) {
  ivec4 place = buf.list_place[i];
  uint s = uint(place.w);
  EXACT double along = component_of(buf.list_given[i], axis) - double(place.x) * buf.list_system[s].row.of[axis] -
                       double(place.y) * buf.list_system[s].row.of[3u + axis] -
                       double(place.z) * buf.list_system[s].row.of[6u + axis];
  EXACT double scaled = (along - buf.list_system[s].origin[axis]) * buf.list_system[s].scale;
  return float(scaled);
}

}  // namespace spherepair
