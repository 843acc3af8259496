// SPDX-License-Identifier: MIT
// The cells within a point's reach, as contiguous ranges of binned points, each in one image; which of these points the
// list has; and their keys.
#include "shaders/list/list.glsl"
#include "common/shared/list_exact.h"

layout(std430, binding = SLOT_CELL) restrict readonly buffer CellBuffer { uint cell[]; };
layout(std430, binding = SLOT_ID) restrict readonly buffer IdBuffer { uint id[]; };
layout(std430, binding = SLOT_SORTED) restrict readonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_LIST_LOOK) restrict readonly buffer ListLookBuffer { ListLook list_look[]; };
layout(std430, binding = SLOT_LIST_KEY) restrict writeonly buffer ListKeyBuffer { uint list_keys[]; };
layout(std430, binding = SLOT_LIST_EXCLUDED) restrict readonly buffer ListExcludedBuffer { uvec2 list_excluded[]; };

shared uint found[LIST_BLOCK];  // pairs of each row of the group

// A row of cells along x. The binned points begin <= k < end are its current range, all in one image.
struct CellRow {
  uint first, x, left;  // the cell at x = 0 of the system; the next cell, and how many
  uint begin, end;
  ivec4 image;
};

CellRow row_at(ListLook look, uint y, uint z) {
  uint s = look.system;
  y += look.cell_y;
  z += look.cell_z;
  uint cells_y = list_system[s].cells[1];
  uint cells_z = list_system[s].cells[2];
  uint beyond_y = y < cells_y ? 0u : y / cells_y;
  uint beyond_z = z < cells_z ? 0u : z / cells_z;
  CellRow row;
  row.first = ((z - beyond_z * cells_z) * cells_y + y - beyond_y * cells_y) * list_system[s].cells[0];
  row.first += list_system[s].first_cell;
  row.x = look.cell_x;
  row.left = look.along_x;
  row.image = ivec4(look.image_x - 1, look.image_y + int(beyond_y), look.image_z + int(beyond_z), 0);
  return row;
}

// Moves on to the next range, which lies in the next image.
CellRow next_range(ListLook look, CellRow row) {
  uint cells = min(row.left, list_system[look.system].cells[0] - row.x);
  row.begin = cell[row.first + row.x];
  row.end = cell[row.first + row.x + cells];
  row.x = 0u;
  row.left -= cells;
  ++row.image.x;
  return row;
}

// Where the point that looks lies, seen from an image.
vec4 seen_from(ListLook look, ivec4 image) {
  if (image.x == 0 && image.y == 0 && image.z == 0) return look.place;
  EXACT float x = look.place.x - scaled_boxes(look.system, image, 0u);
  EXACT float y = look.place.y - scaled_boxes(look.system, image, 1u);
  EXACT float z = look.place.z - scaled_boxes(look.system, image, 2u);
  return vec4(x, y, z, look.place.w);
}

bool is_excluded(uint i, uint j) {
  uint first = has_flag(LIST_ASKS) ? i : min(i, j);
  uint second = has_flag(LIST_ASKS) ? j : max(i, j);
  uint low = 0u;
  uint high = list_state[0].exclusions;
  while (low < high) {
    uint middle = (low + high) / 2u;
    uvec2 pair = list_excluded[middle];
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
bool lists_all() { return !has_flag(LIST_HALF | LIST_SELF_PAIRS) && list_state[0].exclusions == 0u; }

// Half lists have one of (i, j, S) and (j, i, -S); (i, i, 0) is only in lists with self_pairs.
bool is_wanted(uint i, uint j, ivec4 image) {
  if (list_state[0].exclusions != 0u && is_excluded(i, j)) return false;
  if (has_flag(LIST_ASKS)) return true;
  if (i != j) return i < j || !has_flag(LIST_HALF);
  int first = image.x != 0 ? image.x : image.y != 0 ? image.y : image.z;
  return first == 0 ? has_flag(LIST_SELF_PAIRS) : first > 0 || !has_flag(LIST_HALF);
}

bool is_within_reach(uint i, uint j, ivec4 image) {
  uint element = element_of(i);
  ivec4 mine = list_place[element];
  ivec4 other = list_place[j];
  return list_within_reach(list_given[element], list_given[j], list_system[mine.w].row, image.x + mine.x - other.x,
                           image.y + mine.y - other.y, image.z + mine.z - other.z, list_state[0].cutoff,
                           list_state[0].skin, has_flag(LIST_INCLUSIVE));
}

// Tests up to 32 binned points in float32. Each has a bit, the last point the lowest: x has those that are within reach
// for certain, y also those that float32 leaves undecided.
uvec2 filtered(ListLook look, CellRow row, uint begin, uint end, float tolerance) {
  vec4 from = seen_from(look, row.image);
  uvec2 bits = uvec2(0u, 0u);
  for (uint at = begin; at < end; ++at) {
    vec4 other = sorted[at];
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
uvec2 listed_points(ListLook look, CellRow row, uint begin, uint end, bool all, bool exact) {
  uvec2 bits = filtered(look, row, begin, end, list_system[look.system].tolerance);
  bool given = row.image.x == 0 && row.image.y == 0 && row.image.z == 0;
  if (all && given && look.self >= begin && look.self < end) {
    uint others = ~(1u << (end - 1u - look.self));
    bits = uvec2(bits.x & others, bits.y & others);
  }
  uint undecided = bits.y & ~bits.x;
  uint listed = bits.x;
  uint open = (all ? 0u : bits.x) | (exact ? undecided : 0u);
  while (open != 0u) {
    uint bit = open & (~open + 1u);
    uint j = id[end - 1u - lowest_bit(open)];
    open ^= bit;
    bool is_pair = is_wanted(look.i, j, row.image);
    if (exact && is_pair && (undecided & bit) != 0u) is_pair = is_within_reach(look.i, j, row.image);
    listed = is_pair ? listed | bit : listed & ~bit;
  }
  return uvec2(listed, undecided);
}

// The number of an image, which the key of a pair ends with.
uint number_of_image(uint s, ivec4 image) {
  uint x = uint(image.x + int(list_system[s].images[0]));
  uint y = uint(image.y + int(list_system[s].images[1]));
  uint z = uint(image.z + int(list_system[s].images[2]));
  return (x * (2u * list_system[s].images[1] + 1u) + y) * (2u * list_system[s].images[2] + 1u) + z;
}

// Room for the keys of a row.
struct KeyRange {
  uint64_t first;
  uint count;
};

// Adds pairs to a row of the group, and writes their keys as far as there is room.
void add_pairs(ListLook look, CellRow row, uint end, uint listed, KeyRange to, uint group_row) {
  uint n = atomicAdd(found[group_row], count_bits(listed));
  uint first_point = list_system[look.system].first_point;
  uint key_bits = list_system[look.system].key_bits;
  uint number = number_of_image(look.system, row.image);
  for (; listed != 0u && n < to.count; ++n) {
    uint j = id[end - 1u - lowest_bit(listed)];
    list_keys[column_index(to.first + uint64_t(n))] = (j - first_point) << key_bits | number;
    listed &= listed - 1u;
  }
}

// Adds a thread's share of the pairs of a row that float32 decides, or with `exact` only of those that it does not.
// Returns whether there may be such pairs. Threads of one row take rows of cells in turns.
bool look_through(ListLook look, uint lane, uint lanes, KeyRange to, uint group_row, bool exact) {
  bool all = lists_all();
  uint undecided = 0u;
  uint z = 0u;
  for (uint y = lane; true; y += lanes) {
    for (; y >= look.along_y; y -= look.along_y) ++z;
    if (z >= look.along_z) return undecided != 0u;
    CellRow row = row_at(look, y, z);
    while (row.left != 0u) {
      row = next_range(look, row);
      for (uint at = row.begin; at < row.end; at += 32u) {
        uint end = min(at + 32u, row.end);
        uvec2 listed = listed_points(look, row, at, end, all, exact);
        undecided |= listed.y;
        if (exact) listed.x &= listed.y;
        if (listed.x != 0u) add_pairs(look, row, end, listed.x, to, group_row);
      }
    }
  }
  return false;
}

void find_pairs(ListLook look, uint lane, uint lanes, KeyRange to, uint group_row) {
  if (look_through(look, lane, lanes, to, group_row, false)) look_through(look, lane, lanes, to, group_row, true);
}
