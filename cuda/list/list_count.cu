// SPDX-License-Identifier: MIT
// One group per point or query with many neighbours, in turns until none is left: counts the pairs of its row.
#include "cuda/list/list_group.cuh"

namespace spherepair {

__shared__ uint found;

__device__ inline uint pairs_of(const KernelBuffers& buf, ListLook look) {
  float error = buf.list_system[look.system].error;
  uint rows = rows_of(buf, look);
  uint own = 0u;
  for (uint first = 0u; first < rows; first += LIST_BLOCK) {
    uint points = take_rows(buf, look, first, rows);
    uint row = 0u;
    for (uint k = threadIdx.x; k < points; k += LIST_BLOCK) {
      row = row_from(row, k);
      own += uint(is_listed(buf, look, error, row_begin[row] + k, row_shift[row], row_image[row]));
    }
    __syncthreads();
  }
  return own;
}

__global__ void __launch_bounds__(LIST_BLOCK, 24) list_count(Params p, KernelBuffers buf) {
  if (buf.list_state[0].dense == 0u || !is_right(buf)) return;
  for (uint k = group_index(p); k < buf.list_state[0].looking; k += group_count()) {
    ListLook look = buf.list_look[k];
    if (threadIdx.x == 0u) found = 0u;
    __syncthreads();
    uint own = pairs_of(buf, look);
    if (own != 0u) atomicAdd(&found, own);
    __syncthreads();
    if (threadIdx.x == 0u) buf.row_length[look.i] = found;
    __syncthreads();
  }
}

Entry list_count_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_count); }

}  // namespace spherepair
