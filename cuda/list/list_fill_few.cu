// SPDX-License-Identifier: MIT
// One thread per point or query with few neighbours: writes its row of the list. A pair's place in the row is the
// number of smaller keys.
#include "cuda/list/list_columns.cuh"
#include "cuda/list/list_row.cuh"

namespace spherepair {

__shared__ uint64_t keys[LIST_FEW * LIST_FEW_BLOCK];

__global__ void __launch_bounds__(LIST_FEW_BLOCK, 8) list_fill_few(Params p, KernelBuffers buf) {
  uint thread = threadIdx.x;
  uint k = group_index(p) * LIST_FEW_BLOCK + thread;
  if (k >= buf.list_state[0].looking || !is_right(buf) || buf.list_state[0].dense != 0u) return;
  ListLook look = buf.list_look[k];
  uint length = length_to_write(buf, look.i);
  if (length == 0u || length > LIST_FEW) return;
  float error = buf.list_system[look.system].error;
  uint found = 0u;
  uint rows = rows_of(buf, look);
  for (uint r = 0u; r < rows; ++r) {
    CellRow row = row_at(buf, look, r);
    for (uint at = row.begin; at < row.end; ++at) {
      if (!is_listed(buf, look, error, at, row.shift, row.image) || found == length) continue;
      keys[found * LIST_FEW_BLOCK + thread] = list_key(buf.id[at], row.image.x, row.image.y, row.image.z);
      ++found;
    }
  }
  for (uint n = 0u; n < found; ++n) {
    uint64_t key = keys[n * LIST_FEW_BLOCK + thread];
    uint rank = 0u;
    for (uint m = 0u; m < found; ++m) rank += uint(keys[m * LIST_FEW_BLOCK + thread] < key);
    write_pair(buf, look.i, uint64_t(buf.list_begin[look.i]) + uint64_t(rank), key);
  }
}

Entry list_fill_few_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_fill_few); }

}  // namespace spherepair
