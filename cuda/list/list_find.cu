// SPDX-License-Identifier: MIT
// The threads of list_count once more: those of rows whose keys it had no room for write them.
#include "cuda/list/list_length.cuh"
#include "cuda/list/list_row.cuh"

namespace spherepair {

__global__ void __launch_bounds__(LIST_BLOCK, 8) list_find(Params p, KernelBuffers buf) {
  if (!is_right(buf) || !has_room(buf)) return;
  uint thread = threadIdx.x;
  uint bits = buf.list_state[0].row_bits;
  uint k = (group_index(p) * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  found[thread] = 0u;
  __syncthreads();
  if (k >= buf.list_state[0].looking) return;
  uint i = buf.list_look[k].i;
  KeyRange row;
  row.count = buf.row_length[i];
  if (row.count <= buf.list_state[0].kept) return;
  row.first = keys_at(buf, i, row.count);
  find_pairs(buf, buf.list_look[k], thread & (lanes - 1u), lanes, row, thread >> bits);
}

Entry list_find_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_find); }

}  // namespace spherepair
