// SPDX-License-Identifier: MIT
// The cells within a point's reach, as contiguous ranges of binned points, each in one image; which of these points the
// list has; and their keys.
#pragma once

#include "common/shared/list_exact.h"
#include "cuda/list/list.cuh"

namespace spherepair {

__shared__ uint found[LIST_BLOCK];  // pairs of each row of the group

// A row of cells along x. The binned points begin <= k < end are its current range, all in one image.
struct CellRow {
  uint first, x, left;  // the cell at x = 0 of the system; the next cell, and how many
  uint begin, end;
  ivec4 image;
};

__device__ inline CellRow row_at(const KernelBuffers& buf, ListLook look, uint y, uint z) {
  uint s = look.system;
  y += look.cell_y;
  z += look.cell_z;
  uint cells_y = buf.list_system[s].cells[1];
  uint cells_z = buf.list_system[s].cells[2];
  uint beyond_y = y < cells_y ? 0u : y / cells_y;
  uint beyond_z = z < cells_z ? 0u : z / cells_z;
  CellRow row;
  row.first = ((z - beyond_z * cells_z) * cells_y + y - beyond_y * cells_y) * buf.list_system[s].cells[0];
  row.first += buf.list_system[s].first_cell;
  row.x = look.cell_x;
  row.left = look.along_x;
  row.image = ivec4{look.image_x - 1, look.image_y + int(beyond_y), look.image_z + int(beyond_z), 0};
  return row;
}

// Moves on to the next range, which lies in the next image.
__device__ inline CellRow next_range(const KernelBuffers& buf, ListLook look, CellRow row) {
  uint cells = min(row.left, buf.list_system[look.system].cells[0] - row.x);
  row.begin = buf.cell[row.first + row.x];
  row.end = buf.cell[row.first + row.x + cells];
  row.x = 0u;
  row.left -= cells;
  ++row.image.x;
  return row;
}

// Where the point that looks lies, seen from an image.
__device__ inline vec4 seen_from(const KernelBuffers& buf, ListLook look, ivec4 image) {
  if (image.x == 0 && image.y == 0 && image.z == 0) return look.place;
  EXACT float x = look.place.x - scaled_boxes(buf, look.system, image, 0u);
  EXACT float y = look.place.y - scaled_boxes(buf, look.system, image, 1u);
  EXACT float z = look.place.z - scaled_boxes(buf, look.system, image, 2u);
  return vec4{x, y, z, look.place.w};
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

// Whether the list has every pair within reach except (i, i, 0).
__device__ inline bool lists_all(const KernelBuffers& buf) {
  return !has_flag(buf, LIST_HALF | LIST_SELF_PAIRS) && buf.list_state[0].exclusions == 0u;
}

// Half lists have one of (i, j, S) and (j, i, -S); (i, i, 0) is only in lists with self_pairs.
__device__ inline bool is_wanted(const KernelBuffers& buf, uint i, uint j, ivec4 image) {
  if (buf.list_state[0].exclusions != 0u && is_excluded(buf, i, j)) return false;
  if (has_flag(buf, LIST_ASKS)) return true;
  if (i != j) return i < j || !has_flag(buf, LIST_HALF);
  int first = image.x != 0 ? image.x : image.y != 0 ? image.y : image.z;
  return first == 0 ? has_flag(buf, LIST_SELF_PAIRS) : first > 0 || !has_flag(buf, LIST_HALF);
}

__device__ inline bool is_within_reach(const KernelBuffers& buf, uint i, uint j, ivec4 image) {
  uint element = element_of(buf, i);
  ivec4 mine = buf.list_place[element];
  ivec4 other = buf.list_place[j];
  return list_within_reach(buf.list_given[element], buf.list_given[j], buf.list_system[mine.w].row,
                           image.x + mine.x - other.x, image.y + mine.y - other.y, image.z + mine.z - other.z,
                           buf.list_state[0].cutoff, buf.list_state[0].skin, has_flag(buf, LIST_INCLUSIVE));
}

// Tests up to 32 binned points in float32. Each has a bit, the last point the lowest: x has those that are within reach
// for certain, y also those that float32 leaves undecided.
__device__ inline uvec2 filtered(const KernelBuffers& buf, ListLook look, CellRow row, uint begin, uint end,
                                 float tolerance) {
  vec4 from = seen_from(buf, look, row.image);
  uvec2 bits = uvec2{0u, 0u};
  for (uint at = begin; at < end; ++at) {
    vec4 other = buf.sorted[at];
    EXACT float x = other.x - from.x;
    EXACT float y = other.y - from.y;
    EXACT float z = other.z - from.z;
    EXACT float reach = from.w + other.w;
    EXACT float in_plane = multiply_add(x, x, y * y);
    EXACT float squared = multiply_add(z, z, in_plane);
    EXACT float beyond = multiply_add(reach, -reach, squared);
    EXACT float most = beyond + tolerance;
    EXACT float least = beyond - tolerance;
    bits.x = bits.x << 1 | float_bits(most) >> 31;
    bits.y = bits.y << 1 | float_bits(least) >> 31;
  }
  return bits;
}

// Returns in x the bits of the points that the list pairs with the point that looks, in y those that float32 leaves
// undecided. With `exact` these are decided on the numbers as given; otherwise x lacks them.
__device__ inline uvec2 listed_points(const KernelBuffers& buf, ListLook look, CellRow row, uint begin, uint end,
                                      bool all, bool exact) {
  uvec2 bits = filtered(buf, look, row, begin, end, buf.list_system[look.system].tolerance);
  bool given = row.image.x == 0 && row.image.y == 0 && row.image.z == 0;
  if (all && given && look.self >= begin && look.self < end) {
    uint others = ~(1u << (end - 1u - look.self));
    bits = uvec2{bits.x & others, bits.y & others};
  }
  uint undecided = bits.y & ~bits.x;
  uint listed = bits.x;
  uint open = (all ? 0u : bits.x) | (exact ? undecided : 0u);
  while (open != 0u) {
    uint bit = open & (~open + 1u);
    uint j = buf.id[end - 1u - lowest_bit(open)];
    open ^= bit;
    bool is_pair = is_wanted(buf, look.i, j, row.image);
    if (exact && is_pair && (undecided & bit) != 0u) is_pair = is_within_reach(buf, look.i, j, row.image);
    listed = is_pair ? listed | bit : listed & ~bit;
  }
  return uvec2{listed, undecided};
}

// The number of an image, which the key of a pair ends with.
__device__ inline uint number_of_image(const KernelBuffers& buf, uint s, ivec4 image) {
  uint x = uint(image.x + int(buf.list_system[s].images[0]));
  uint y = uint(image.y + int(buf.list_system[s].images[1]));
  uint z = uint(image.z + int(buf.list_system[s].images[2]));
  return (x * (2u * buf.list_system[s].images[1] + 1u) + y) * (2u * buf.list_system[s].images[2] + 1u) + z;
}

// Room for the keys of a row.
struct KeyRange {
  uint64_t first;
  uint count;
};

// Adds pairs to a row of the group, and writes their keys as far as there is room.
__device__ inline void add_pairs(const KernelBuffers& buf, ListLook look, CellRow row, uint end, uint listed,
                                 KeyRange to, uint group_row) {
  uint n = atomicAdd(&found[group_row], count_bits(listed));
  uint first_point = buf.list_system[look.system].first_point;
  uint key_bits = buf.list_system[look.system].key_bits;
  uint number = number_of_image(buf, look.system, row.image);
  for (; listed != 0u && n < to.count; ++n) {
    uint j = buf.id[end - 1u - lowest_bit(listed)];
    buf.list_keys[column_index(to.first + uint64_t(n))] = (j - first_point) << key_bits | number;
    listed &= listed - 1u;
  }
}

// Adds a thread's share of the pairs of a row that float32 decides, or with `exact` only of those that it does not.
// Returns whether there may be such pairs. Threads of one row take rows of cells in turns.
__device__ inline bool look_through(const KernelBuffers& buf, ListLook look, uint lane, uint lanes, KeyRange to,
                                    uint group_row, bool exact) {
  bool all = lists_all(buf);
  uint undecided = 0u;
  uint z = 0u;
  for (uint y = lane; true; y += lanes) {
    for (; y >= look.along_y; y -= look.along_y) ++z;
    if (z >= look.along_z) return undecided != 0u;
    CellRow row = row_at(buf, look, y, z);
    while (row.left != 0u) {
      row = next_range(buf, look, row);
      for (uint at = row.begin; at < row.end; at += 32u) {
        uint end = min(at + 32u, row.end);
        uvec2 listed = listed_points(buf, look, row, at, end, all, exact);
        undecided |= listed.y;
        if (exact) listed.x &= listed.y;
        if (listed.x != 0u) add_pairs(buf, look, row, end, listed.x, to, group_row);
      }
    }
  }
  return false;
}

__device__ inline void find_pairs(const KernelBuffers& buf, ListLook look, uint lane, uint lanes, KeyRange to,
                                  uint group_row) {
  if (look_through(buf, look, lane, lanes, to, group_row, false))
    look_through(buf, look, lane, lanes, to, group_row, true);
}

}  // namespace spherepair
