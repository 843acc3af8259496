// SPDX-License-Identifier: MIT
// The region that a group looks through for the pairs of 2^row_bits rows, which are in the order of their cells. Rows
// that are near each other look together. The group visits the cells that enclose the reach of all of them, and copies
// the points within reach of the box around the rows to shared memory.
#pragma once

#include "cuda/list/list.cuh"

namespace spherepair {

__shared__ uint own_point[LIST_ROWS];  // where a row's own point is staged; ~0: nowhere
__shared__ uint leader, undecided_rows;
__shared__ ListLook leading;
__shared__ int bounds[LIST_BOUNDS * (LIST_ROWS + 1u)];  // of each row, then the least of all
__shared__ uint range_begin[LIST_RANGES];  // ranges of binned points, each in one image: where they begin, ...
__shared__ uint range_length[LIST_RANGES];
__shared__ uint range_upto[LIST_RANGES + 1u];  // ... the points of those before, ...
__shared__ uint range_image[LIST_RANGES];      // ... the image's number, ...
__shared__ vec4 range_shift[LIST_RANGES];      // ... and where it lies, scaled
constexpr uint STAGED = 2u * LIST_BLOCK;       // CUDA only: the largest group's
__shared__ uint staged;
__shared__ vec4 staged_point[STAGED];
__shared__ uint staged_key[STAGED];

__device__ inline uint group_threads() { return blockDim.x; }  // CUDA only: GLSL compiles a kernel for each size
__device__ inline uint group_rows(const KernelBuffers& buf) { return 1u << buf.list_state[0].row_bits; }
__device__ inline uint lane_of_row(const KernelBuffers& buf) { return threadIdx.x & (group_rows(buf) - 1u); }

// Chooses the first row that waits, and returns whether this one looks together with it. No row: leader is LIST_ROWS.
__device__ inline bool joins_leader(const KernelBuffers& buf, ListLook look, bool waits) {
  uint lane = lane_of_row(buf);
  __syncthreads();
  if (threadIdx.x == 0u) {
    leader = LIST_ROWS;
    undecided_rows = 0u;
  }
  __syncthreads();
  if (waits) atomicMin(&leader, lane);
  __syncthreads();
  if (waits && threadIdx.x == leader) leading = look;
  __syncthreads();
  if (!waits || look.system != leading.system) return false;
  bool near = true;
  for (uint k = 0u; k < 3u; ++k) {
    int apart = look.low[k] - leading.low[k];
    near = near && apart <= LIST_NEAR && -apart <= LIST_NEAR;
  }
  return near;
}

// Bounds the cells and the places of the rows that look together, and their part of the reach.
__device__ inline void bound_rows(const KernelBuffers& buf, ListLook look, vec4 place, bool joins) {
  uint thread = threadIdx.x;
  uint rows = group_rows(buf);
  if (thread < rows) {
    int most = 0x7FFFFFFF;
    for (uint k = 0u; k < 3u; ++k) {
      bounds[k * (LIST_ROWS + 1u) + thread] = joins ? look.low[k] : most;
      bounds[(3u + k) * (LIST_ROWS + 1u) + thread] = joins ? -look.high[k] : most;
    }
    bounds[6u * (LIST_ROWS + 1u) + thread] = joins ? ordered_code(place.x) : most;
    bounds[7u * (LIST_ROWS + 1u) + thread] = joins ? ordered_code(place.y) : most;
    bounds[8u * (LIST_ROWS + 1u) + thread] = joins ? ordered_code(place.z) : most;
    bounds[9u * (LIST_ROWS + 1u) + thread] = joins ? ordered_code(-place.x) : most;
    bounds[10u * (LIST_ROWS + 1u) + thread] = joins ? ordered_code(-place.y) : most;
    bounds[11u * (LIST_ROWS + 1u) + thread] = joins ? ordered_code(-place.z) : most;
    bounds[12u * (LIST_ROWS + 1u) + thread] = joins ? ordered_code(-place.w) : most;
  }
  __syncthreads();
  if (thread < LIST_BOUNDS) {
    int least = bounds[thread * (LIST_ROWS + 1u)];
    for (uint row = 1u; row < rows; ++row) least = min(least, bounds[thread * (LIST_ROWS + 1u) + row]);
    bounds[thread * (LIST_ROWS + 1u) + LIST_ROWS] = least;
  }
  __syncthreads();
}

__device__ inline int bound(uint k) { return bounds[k * (LIST_ROWS + 1u) + LIST_ROWS]; }

// The box around the rows that look together, and the largest part of their reach.
struct RowBox {
  vec4 low, high;
};
__device__ inline RowBox box_of_rows() {
  RowBox box;
  box.low = vec4{number_of_code(bound(6u)), number_of_code(bound(7u)), number_of_code(bound(8u)), 0.0f};
  box.high = vec4{-number_of_code(bound(9u)), -number_of_code(bound(10u)), -number_of_code(bound(11u)),
                  -number_of_code(bound(12u))};
  return box;
}

// Ranges of binned points in the cells of `look`: one for each row of cells along x, and each image of it.
struct Region {
  ListLook look;
  uint along_x, along_y, ranges;
  int image_x;
  uint first_point, key_bits, no_image;  // of keys
};
__device__ inline Region region_of(const KernelBuffers& buf, ListLook look) {
  uint s = look.system;
  int cells_x = int(buf.list_system[s].cells[0]);
  Region region;
  region.look = look;
  region.image_x = floor_divide(look.low[0], cells_x);
  region.along_x = uint(floor_divide(look.high[0] - 1, cells_x) - region.image_x + 1);
  region.along_y = uint(look.high[1] - look.low[1]);
  region.ranges = region.along_x * region.along_y * uint(look.high[2] - look.low[2]);
  region.first_point = buf.list_system[s].first_point;
  region.key_bits = buf.list_system[s].key_bits;
  region.no_image = images_of(buf, s).none;
  return region;
}
__device__ inline Region region_of_rows(const KernelBuffers& buf) {
  ListLook look = leading;
  for (uint k = 0u; k < 3u; ++k) {
    look.low[k] = bound(k);
    look.high[k] = -bound(3u + k);
  }
  return region_of(buf, look);
}

// The points in a row of cells of one image.
struct PointRange {
  uint begin, end, image;
  vec4 shift;  // of the image, scaled
};
__device__ inline PointRange range_of(const KernelBuffers& buf, Region region, uint number) {
  uint s = region.look.system;
  uint row = number / region.along_x;
  uint layer = row / region.along_y;
  int cells_x = int(buf.list_system[s].cells[0]);
  int cells_y = int(buf.list_system[s].cells[1]);
  int cells_z = int(buf.list_system[s].cells[2]);
  int y = region.look.low[1] + int(row - layer * region.along_y);
  int z = region.look.low[2] + int(layer);
  ivec4 image =
      ivec4{region.image_x + int(number - row * region.along_x), floor_divide(y, cells_y), floor_divide(z, cells_z), 0};
  int first = ((z - image.z * cells_z) * cells_y + y - image.y * cells_y - image.x) * cells_x;
  uint first_cell = buf.list_system[s].first_cell;
  PointRange range;
  range.begin = buf.cell[first_cell + uint(first + max(region.look.low[0], image.x * cells_x))];
  range.end = buf.cell[first_cell + uint(first + min(region.look.high[0], (image.x + 1) * cells_x))];
  range.image = number_of_image(images_of(buf, s), image);
  range.shift = vec4{0.0f, 0.0f, 0.0f, 0.0f};
  if (range.image != region.no_image)
    range.shift =
        vec4{scaled_boxes(buf, s, image, 0u), scaled_boxes(buf, s, image, 1u), scaled_boxes(buf, s, image, 2u), 0.0f};
  return range;
}

// A point of a range, where the range's image has it.
__device__ inline vec4 place_in_range(const KernelBuffers& buf, uint at, vec4 shift) {
  vec4 place = buf.sorted[at];
  EXACT float x = place.x + shift.x;
  EXACT float y = place.y + shift.y;
  EXACT float z = place.z + shift.z;
  return vec4{x, y, z, place.w};
}
__device__ inline uint key_in_range(const KernelBuffers& buf, Region region, uint at, uint image) {
  return (buf.id[at] - region.first_point) << region.key_bits | image;
}

__device__ inline void set_range(const KernelBuffers& buf, Region region, uint r, uint number) {
  PointRange range = range_of(buf, region, number);
  range_begin[r] = range.begin;
  range_length[r] = range.end - range.begin;
  range_image[r] = range.image;
  range_shift[r] = range.shift;
}

// Sets up to LIST_RANGES ranges from the first on.
__device__ inline void set_ranges(const KernelBuffers& buf, Region region, uint first) {
  uint r = threadIdx.x;
  uint ranges = min(region.ranges - first, LIST_RANGES);
  if (r < ranges) set_range(buf, region, r, first + r);
  if (r >= ranges && r < LIST_RANGES) range_length[r] = 0u;
  __syncthreads();
  if (r < LIST_RANGES) {
    uint upto = 0u;
    for (uint k = 0u; k < r; ++k) upto += range_length[k];
    range_upto[r] = upto;
    if (r == LIST_RANGES - 1u) range_upto[LIST_RANGES] = upto + range_length[r];
  }
  __syncthreads();
}

// Stages the k-th point of the ranges if it is within reach of the box around the rows.
__device__ inline void stage(const KernelBuffers& buf, Region region, RowBox box, float tolerance, uint k,
                             uint first_row) {
  uint r = 0u;
  for (uint step = LIST_RANGES / 2u; step != 0u; step /= 2u)
    if (range_upto[r + step] <= k) r += step;
  uint at = range_begin[r] + (k - range_upto[r]);
  vec4 other = place_in_range(buf, at, range_shift[r]);
  EXACT float below_x = box.low.x - other.x;
  EXACT float below_y = box.low.y - other.y;
  EXACT float below_z = box.low.z - other.z;
  EXACT float above_x = other.x - box.high.x;
  EXACT float above_y = other.y - box.high.y;
  EXACT float above_z = other.z - box.high.z;
  EXACT float reach = box.high.w + other.w;
  float beyond = list_beyond(max(max(below_x, above_x), 0.0f), max(max(below_y, above_y), 0.0f),
                             max(max(below_z, above_z), 0.0f), reach);
  if (beyond > tolerance) return;
  uint n = atomicAdd(&staged, 1u);
  staged_point[n] = other;
  staged_key[n] = key_in_range(buf, region, at, range_image[r]);
  if (at - first_row < group_rows(buf) && range_image[r] == region.no_image) own_point[at - first_row] = n;
}

}  // namespace spherepair
