// SPDX-License-Identifier: MIT
// One thread per point: writes its index to its place in its cell.
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_scatter(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i >= buf.list_state[0].points) return;
  uvec2 own = buf.list_bins[i];
  buf.id[buf.cell[own.x] + own.y] = i;
}

Entry list_scatter_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_scatter); }

}  // namespace spherepair
