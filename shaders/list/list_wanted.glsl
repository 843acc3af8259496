// SPDX-License-Identifier: MIT
// Whether a pair belongs to the list: half lists, exclusions and self pairs, and the distance of the numbers as given.
#include "common/shared/list_exact.h"

layout(std430, binding = SLOT_LIST_EXCLUDED) restrict readonly buffer ListExcludedBuffer { uvec2 list_excluded[]; };

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
