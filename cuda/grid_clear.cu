// SPDX-License-Identifier: MIT
// One thread per four cells: no sphere is counted yet, no tile of the scan is done, no result is found.
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) grid_clear(Params p, World w) {
  uint k = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (k <= p.cell_slots / 4u) reinterpret_cast<uvec4*>(w.cell)[k] = uvec4{0u, 0u, 0u, 0u};
  if (k <= p.scan_tiles) w.scan[k] = 0u;
  if (k < SUMMARY_SLOTS * SUMMARY_WORDS) w.summary[k] = 0u;
}

Entry grid_clear_kernel() { return reinterpret_cast<Entry>(&grid_clear); }

}  // namespace spherepair
