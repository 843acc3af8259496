// SPDX-License-Identifier: MIT
// One thread per point: counts it in the slot behind its cell, where the prefix sums then leave the begin of the cell
// and list_scatter that of the next.
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_bin(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i < buf.list_state[0].points) atomicAdd(&buf.cell[cell_of(buf, i) + 1u], 1u);
}

Entry list_bin_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_bin); }

}  // namespace spherepair
