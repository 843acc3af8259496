// SPDX-License-Identifier: MIT
// One thread per row of the list, or several where there are few rows: counts its pairs, and keeps their keys.
#include "cuda/list/list_row.cuh"

namespace spherepair {

__global__ void __launch_bounds__(LIST_BLOCK, 8) list_count(Params p, KernelBuffers buf) {
  if (!is_right(buf)) return;
  uint thread = threadIdx.x;
  uint bits = buf.list_state[0].row_bits;
  uint k = (group_index(p) * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  uint lane = thread & (lanes - 1u);
  bool looks = k < buf.list_state[0].looking;
  found[thread] = 0u;
  __syncthreads();
  if (looks) {
    KeyRange kept;
    kept.first = uint64_t(buf.list_look[k].i) * uint64_t(buf.list_state[0].kept);
    kept.count = buf.list_state[0].kept;
    find_pairs(buf, buf.list_look[k], lane, lanes, kept, thread >> bits);
  }
  __syncthreads();
  if (looks && lane == 0u) buf.row_length[buf.list_look[k].i] = found[thread >> bits];
}

Entry list_count_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_count); }

}  // namespace spherepair
