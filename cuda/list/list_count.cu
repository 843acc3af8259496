// SPDX-License-Identifier: MIT
// One group per 2^row_bits rows of the list: counts their pairs, and keeps their keys.
#include "cuda/list/list_row.cuh"

namespace spherepair {

__shared__ uint is_long;  // not 0: a row of the group has more keys than are kept

template <bool LONG_ROWS>
__global__ void __launch_bounds__(LIST_BLOCK, 8) list_count(Params p, KernelBuffers buf) {
  wait_first(p);  // CUDA only: it gets ready early
  uint first = group_index(p) << buf.list_state[0].row_bits;
  if (!is_right(buf) || first >= buf.list_state[0].looking) return;
  uint k = first + lane_of_row(buf);
  bool looks = k < buf.list_state[0].looking;
  uint i = buf.list_look[looks ? k : first].i;
  KeyRange kept;
  kept.count = buf.list_state[0].kept;
  kept.first = uint64_t(i) * uint64_t(kept.count);
  found[lane_of_row(buf)] = 0u;
  is_long = 0u;
  find_pairs(buf, k, looks, LONG_ROWS, first, kept);
  if (looks && threadIdx.x < group_rows(buf)) {
    uint length = found[lane_of_row(buf)];
    buf.row_length[i] = length;
    if (length > kept.count && atomicMax(&is_long, 1u) == 0u)
      buf.list_long[atomicAdd(&buf.list_state[0].longer, 1u)] = group_index(p);
  }
}

Entry list_count_kernel(uint, Variant variant) {
  return variant.long_rows ? reinterpret_cast<Entry>(&list_count<true>) : reinterpret_cast<Entry>(&list_count<false>);
}

}  // namespace spherepair
