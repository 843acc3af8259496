#version 450
// SPDX-License-Identifier: MIT
// One thread per row of the list, or several where there are few rows: counts its pairs. Threads of one row take rows
// of cells in turns. A thread that finds an undecided pair looks again, and decides on the numbers as given.
#include "shaders/list/list_row.glsl"

layout(std430, binding = SLOT_ROW_LENGTH) restrict writeonly buffer RowLengthBuffer { uint row_length[]; };
layout(std430, binding = SLOT_LIST_MASK) restrict writeonly buffer ListMaskBuffer { uint list_masks[]; };
layout(local_size_x = LIST_BLOCK) in;
shared uint found[LIST_BLOCK];

// The number of pairs; in y not 0 if some are undecided. Keeps the points that it finds for list_find.
uvec2 pairs_of(ListLook look, uint lane, uint lanes, uint thread, bool exact) {
  bool all = lists_all();
  uint threads = list_state[0].looking * lanes;
  uint word = 0u;
  uvec2 pairs = uvec2(0u, 0u);
  uint z = 0u;
  for (uint y = lane; true; y += lanes) {
    for (; y >= look.along_y; y -= look.along_y) ++z;
    if (z >= look.along_z) return pairs;
    CellRow row = row_at(look, y, z);
    while (row.left != 0u) {
      row = next_range(look, row);
      for (uint at = row.begin; at < row.end; at += 32u) {
        uvec2 listed = listed_points(look, row, at, min(at + 32u, row.end), all, exact);
        if (word < list_state[0].mask_words) list_masks[word * threads + thread] = listed.x;
        ++word;
        pairs = uvec2(pairs.x + count_bits(listed.x), pairs.y | listed.y);
      }
    }
  }
  return pairs;
}

void main() {
  if (!is_right()) return;
  uint thread = gl_LocalInvocationID.x;
  uint bits = list_state[0].row_bits;
  uint k = (group_index() * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  uint lane = thread & (lanes - 1u);
  bool looks = k < list_state[0].looking;
  found[thread] = 0u;
  barrier();
  if (looks) {
    uvec2 pairs = pairs_of(list_look[k], lane, lanes, k * lanes + lane, false);
    if (pairs.y != 0u) pairs = pairs_of(list_look[k], lane, lanes, k * lanes + lane, true);
    if (pairs.x != 0u) atomicAdd(found[thread >> bits], pairs.x);
  }
  barrier();
  if (looks && lane == 0u) row_length[list_look[k].i] = found[thread >> bits];
}
