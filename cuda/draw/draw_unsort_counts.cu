// SPDX-License-Identifier: MIT
// One thread per sphere in cell order: writes its contacts by sphere index.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) draw_unsort_counts(Params p, KernelBuffers buf) {
  uint k = group_index(p) * BLOCK + threadIdx.x;
  if (k < p.n) buf.count[sphere_index(p, buf, buf.sorted[k], k)] = buf.sorted_count[k];
}

Entry draw_unsort_counts_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_unsort_counts); }

}  // namespace spherepair
