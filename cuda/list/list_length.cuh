// SPDX-License-Identifier: MIT
// Where a row of the list begins, how long it is, where its keys lie, and whether there is room for all rows.
#pragma once

#include "cuda/list/list.cuh"

namespace spherepair {

// Whether the columns have room for all pairs; else none is written.
__device__ inline bool has_room(const KernelBuffers& buf) {
  return buf.list_begin[buf.list_state[0].looking] <= buf.list_state[0].room;
}

// Where the keys of a row lie: where list_count kept them, or where list_find wrote them if they were too many, behind
// those of all rows.
__device__ inline uint64_t keys_at(const KernelBuffers& buf, uint i, uint length) {
  uint64_t kept = uint64_t(buf.list_state[0].kept);
  if (uint64_t(length) <= kept) return uint64_t(i) * kept;
  return uint64_t(buf.list_state[0].looking) * kept + uint64_t(buf.list_begin[i]);
}

}  // namespace spherepair
