// SPDX-License-Identifier: MIT
// One thread per point or query with few neighbours: counts the pairs of its row.
#include "cuda/list/list_row.cuh"

namespace spherepair {

__global__ void __launch_bounds__(LIST_FEW_BLOCK, 8) list_count_few(Params p, KernelBuffers buf) {
  uint k = group_index(p) * LIST_FEW_BLOCK + threadIdx.x;
  if (k >= buf.list_state[0].looking || !is_right(buf) || buf.list_state[0].dense != 0u) return;
  ListLook look = buf.list_look[k];
  float error = buf.list_system[look.system].error;
  uint length = 0u;
  uint rows = rows_of(buf, look);
  for (uint r = 0u; r < rows; ++r) {
    CellRow row = row_at(buf, look, r);
    for (uint at = row.begin; at < row.end; ++at) length += uint(is_listed(buf, look, error, at, row.shift, row.image));
  }
  buf.row_length[look.i] = length;
  if (length > LIST_FEW) atomicMax(&buf.list_state[0].longest, length);
}

Entry list_count_few_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_count_few); }

}  // namespace spherepair
