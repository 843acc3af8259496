// SPDX-License-Identifier: MIT
// One thread per sphere: sorts its row, so that its impulses are added by ascending index of the other sphere.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) contact_order(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i >= p.n) return;
  uint length = buf.row_length[i];
  for (uint k = 1u; k < length; ++k) {
    uint j = buf.row[k * p.n + i];
    uint to = k;
    for (; to > 0u && buf.row[(to - 1u) * p.n + i] > j; --to) buf.row[to * p.n + i] = buf.row[(to - 1u) * p.n + i];
    buf.row[to * p.n + i] = j;
  }
}

Entry contact_order_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_order); }

}  // namespace spherepair
