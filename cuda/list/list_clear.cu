// SPDX-License-Identifier: MIT
// One thread per slot of the cells, and at least one for every extreme: all 0, and nothing found yet.
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_clear(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i < p.sort.scan_tiles * SCAN_TILE) buf.cell[i] = 0u;
  if (i / LIST_EXTREMES < buf.list_state[0].systems) buf.list_system[i / LIST_EXTREMES].extreme[i % LIST_EXTREMES] = 0u;
  if (i != 0u) return;
  buf.list_state[0].wrong = 0u;
  buf.list_state[0].far = 0u;
  buf.list_state[0].wide = 0u;
  buf.list_state[0].longer = 0u;
}

Entry list_clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_clear); }

}  // namespace spherepair
