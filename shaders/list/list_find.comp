#version 450
// SPDX-License-Identifier: MIT
// One thread per row of the list, or several where there are few rows, as in list_count: writes the keys of its pairs,
// in any order.
#include "shaders/list/list_length.glsl"
#include "shaders/list/list_row.glsl"

layout(std430, binding = SLOT_LIST_KEY) restrict writeonly buffer ListKeyBuffer { uint list_keys[]; };
layout(std430, binding = SLOT_LIST_MASK) restrict readonly buffer ListMaskBuffer { uint list_masks[]; };
layout(local_size_x = LIST_BLOCK) in;
shared uint found[LIST_BLOCK];

// The number of an image, which the key of a pair ends with.
uint number_of_image(uint s, ivec4 image) {
  uint x = uint(image.x + int(list_system[s].images[0]));
  uint y = uint(image.y + int(list_system[s].images[1]));
  uint z = uint(image.z + int(list_system[s].images[2]));
  return (x * (2u * list_system[s].images[1] + 1u) + y) * (2u * list_system[s].images[2] + 1u) + z;
}

void write_keys(ListLook look, CellRow row, uint end, uint listed, uint length, uint group_row) {
  uint n = atomicAdd(found[group_row], count_bits(listed));
  uint64_t first = uint64_t(list_begin[look.i]);
  uint first_point = list_system[look.system].first_point;
  uint key_bits = list_system[look.system].key_bits;
  uint number = number_of_image(look.system, row.image);
  for (; listed != 0u && n < length; ++n) {
    uint j = id[end - 1u - lowest_bit(listed)];
    list_keys[column_index(first + uint64_t(n))] = (j - first_point) << key_bits | number;
    listed &= listed - 1u;
  }
}

// Writes the pairs in the masks of list_count, and looks for those that the masks had no room for. With `exact` it
// writes only pairs outside the masks that float32 leaves undecided. Returns whether there may be such pairs.
bool find_pairs(ListLook look, uint lane, uint lanes, uint thread, uint group_row, bool exact) {
  bool all = lists_all();
  uint threads = list_state[0].looking * lanes;
  uint word = 0u;
  uint length = row_length[look.i];
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
        uvec2 listed = uvec2(0u, 0u);
        if (word >= list_state[0].mask_words) {
          listed = listed_points(look, row, at, end, all, exact);
          undecided |= listed.y;
          if (exact) listed.x &= listed.y;
        } else if (!exact) {
          listed.x = list_masks[word * threads + thread];
        }
        ++word;
        if (listed.x != 0u) write_keys(look, row, end, listed.x, length, group_row);
      }
    }
  }
  return false;
}

void main() {
  if (!is_right() || !has_room()) return;
  uint thread = gl_LocalInvocationID.x;
  uint bits = list_state[0].row_bits;
  uint k = (group_index() * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  found[thread] = 0u;
  barrier();
  uint lane = thread & (lanes - 1u);
  if (k >= list_state[0].looking) return;
  uint own = k * lanes + lane;
  if (find_pairs(list_look[k], lane, lanes, own, thread >> bits, false))
    find_pairs(list_look[k], lane, lanes, own, thread >> bits, true);
}
