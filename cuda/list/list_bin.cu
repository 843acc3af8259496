// SPDX-License-Identifier: MIT
// One thread per point: adds it to the count of its cell, and stores the cell and the point's place in it.
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_bin(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i >= buf.list_state[0].points) return;
  uint own = cell_of(buf, i);
  buf.list_bins[i] = uvec2{own, atomicAdd(&buf.cell[own], 1u)};
}

Entry list_bin_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_bin); }

}  // namespace spherepair
