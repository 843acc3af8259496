// SPDX-License-Identifier: MIT
// The rows of cells within a point's reach, each a contiguous range of binned points in one image, and the test whether
// the list has one of these points.
#pragma once

#include "common/shared/list_exact.h"
#include "cuda/list/list.cuh"

namespace spherepair {

// Whether no invalid number, no point too far away and no reach too long was found.
__device__ inline bool is_right(const KernelBuffers& buf) {
  return (buf.list_state[0].wrong | buf.list_state[0].far | buf.list_state[0].wide) == 0u;
}

__device__ inline int floor_divide(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

__device__ inline uint images_along_x(const KernelBuffers& buf, ListLook look) {
  int cells = int(buf.list_system[look.system].cells[0]);
  return uint(floor_divide(look.high_x, cells) - floor_divide(look.low_x, cells) + 1);
}
__device__ inline uint rows_of(const KernelBuffers& buf, ListLook look) {
  if (look.high_x < look.low_x || look.high_y < look.low_y || look.high_z < look.low_z) return 0u;
  return images_along_x(buf, look) * uint(look.high_y - look.low_y + 1) * uint(look.high_z - look.low_z + 1);
}

struct CellRow {
  uint begin, end;  // binned indices
  vec4 shift;       // of the image
  ivec4 image;
};
__device__ inline CellRow row_at(const KernelBuffers& buf, ListLook look, uint r) {
  uint s = look.system;
  int cells_x = int(buf.list_system[s].cells[0]);
  int cells_y = int(buf.list_system[s].cells[1]);
  int cells_z = int(buf.list_system[s].cells[2]);
  uint images = images_along_x(buf, look);
  uint ys = uint(look.high_y - look.low_y + 1);
  int y = look.low_y + int(r / images % ys);
  int z = look.low_z + int(r / images / ys);
  ivec4 image =
      ivec4{floor_divide(look.low_x, cells_x) + int(r % images), floor_divide(y, cells_y), floor_divide(z, cells_z), 0};
  int from = max(look.low_x - image.x * cells_x, 0);
  int to = min(look.high_x - image.x * cells_x, cells_x - 1);
  uint first = uint((z - image.z * cells_z) * cells_y + y - image.y * cells_y) * uint(cells_x);
  first += buf.list_system[s].first_cell;
  CellRow row;
  row.begin = buf.cell[first + uint(from)];
  row.end = buf.cell[first + uint(to) + 1u];
  row.image = image;
  row.shift = vec4{0.0f, 0.0f, 0.0f, 0.0f};
  if (image.x != 0 || image.y != 0 || image.z != 0)
    row.shift =
        vec4{scaled_boxes(buf, s, image, 0u), scaled_boxes(buf, s, image, 1u), scaled_boxes(buf, s, image, 2u), 0.0f};
  return row;
}

__device__ inline bool is_excluded(const KernelBuffers& buf, uint i, uint j) {
  uint first = has_flag(buf, LIST_ASKS) ? i : min(i, j);
  uint second = has_flag(buf, LIST_ASKS) ? j : max(i, j);
  uint low = 0u;
  uint high = buf.list_state[0].exclusions;
  while (low < high) {
    uint middle = (low + high) / 2u;
    uvec2 pair = buf.list_excluded[middle];
    if (pair.x == first && pair.y == second) return true;
    if (pair.x < first || (pair.x == first && pair.y < second)) {
      low = middle + 1u;
    } else {
      high = middle;
    }
  }
  return false;
}

// Half lists have one of (i, j, S) and (j, i, -S); (i, i, 0) is only in lists with self_pairs.
__device__ inline bool is_wanted(const KernelBuffers& buf, uint i, uint j, ivec4 image) {
  if (has_flag(buf, LIST_ASKS)) return true;
  if (i != j) return i < j || !has_flag(buf, LIST_HALF);
  int first = image.x != 0 ? image.x : image.y != 0 ? image.y : image.z;
  return first == 0 ? has_flag(buf, LIST_SELF_PAIRS) : first > 0 || !has_flag(buf, LIST_HALF);
}

__device__ inline uint element_of(const KernelBuffers& buf, uint i) {
  return has_flag(buf, LIST_ASKS) ? buf.list_state[0].points + i : i;
}

__device__ inline bool is_within_reach(const KernelBuffers& buf, uint i, uint j, ivec4 image) {
  uint element = element_of(buf, i);
  ivec4 mine = buf.list_place[element];
  ivec4 other = buf.list_place[j];
  return list_within_reach(buf.list_given[element], buf.list_given[j], buf.list_system[mine.w].row,
                           image.x + mine.x - other.x, image.y + mine.y - other.y, image.z + mine.z - other.z,
                           buf.list_state[0].cutoff, buf.list_state[0].skin, has_flag(buf, LIST_INCLUSIVE));
}

// Whether the list has the pair with a binned point in an image: a float32 filter, then the numbers as given.
__device__ inline bool is_listed(const KernelBuffers& buf, ListLook look, float error, uint at, vec4 shift,
                                 ivec4 image) {
  vec4 other = buf.sorted[at];
  EXACT float x = other.x + shift.x - look.place.x;
  EXACT float y = other.y + shift.y - look.place.y;
  EXACT float z = other.z + shift.z - look.place.z;
  EXACT float squared = x * x + y * y + z * z;
  EXACT float reach = look.place.w + other.w;
  EXACT float far = reach + error;
  EXACT float near = reach - error;
  EXACT float farthest = far * far * 1.00001f;
  EXACT float nearest = near * near * 0.99999f;
  if (squared > farthest) return false;
  uint j = buf.id[at];
  if (!is_wanted(buf, look.i, j, image)) return false;
  if (buf.list_state[0].exclusions != 0u && is_excluded(buf, look.i, j)) return false;
  return (near > 0.0f && squared < nearest) || is_within_reach(buf, look.i, j, image);
}

}  // namespace spherepair
