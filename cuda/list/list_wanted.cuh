// SPDX-License-Identifier: MIT
// Whether a pair belongs to the list: half lists, exclusions and self pairs, and the distance of the numbers as given.
#pragma once

#include "common/shared/list_exact.h"
#include "cuda/list/list.cuh"

namespace spherepair {

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

}  // namespace spherepair
