// SPDX-License-Identifier: MIT
// Each thread takes SPHERES_PER_SORTER spheres: the results of the last collision step cleared, for a scene that did
// not move.
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) clear(Params p, KernelBuffers w) {
  uint first = group_index(p) * SERVICE_BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) clear_results(p, w, first + k * SERVICE_BLOCK);
}

Entry clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&clear); }

}  // namespace spherepair
