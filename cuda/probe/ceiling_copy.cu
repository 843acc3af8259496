// SPDX-License-Identifier: MIT
// One thread per sphere copies 16 bytes: what remains is the memory's bandwidth.
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) ceiling_copy(Params p, World w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (i >= p.n) return;
  w.velocity[i] = w.position[i];
}

Entry ceiling_copy_kernel(uint, Variant) { return reinterpret_cast<Entry>(&ceiling_copy); }

}  // namespace spherepair
