// SPDX-License-Identifier: MIT
// The groups of list_count with long rows once more: rows whose keys it had no room for write them.
#include "cuda/list/list_length.cuh"
#include "cuda/list/list_row.cuh"

namespace spherepair {

__global__ void __launch_bounds__(LIST_BLOCK, 8) list_find(Params p, KernelBuffers buf) {
  wait_first(p);  // CUDA only: it gets ready early
  if (!is_right(buf) || !has_room(buf)) return;
  for (uint group = group_index(p); group < buf.list_state[0].longer; group += LIST_LONG_GROUPS) {
    uint first = buf.list_long[group] << buf.list_state[0].row_bits;
    uint k = first + lane_of_row(buf);
    bool looks = k < buf.list_state[0].looking;
    uint i = buf.list_look[looks ? k : first].i;
    KeyRange row;
    row.count = buf.row_length[i];
    row.first = keys_at(buf, i, row.count);
    found[lane_of_row(buf)] = 0u;
    find_pairs(buf, k, looks && row.count > buf.list_state[0].kept, false, first, row);
  }
}

Entry list_find_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_find); }

}  // namespace spherepair
