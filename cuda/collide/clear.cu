// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_SORTER spheres: clears the results of the last collision step, for a scene that did not
// move.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) clear(Params p, KernelBuffers buf) {
  uint first = group_index(p) * BLOCK * SPHERES_PER_SORTER + threadIdx.x;
  for (uint k = 0u; k < SPHERES_PER_SORTER; ++k) clear_results(p, buf, first + k * BLOCK);
}

Entry clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&clear); }

}  // namespace spherepair
