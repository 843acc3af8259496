// SPDX-License-Identifier: MIT
// One thread per sphere adds to the count of a scattered other: what remains is the rate of atomics without a result.
#include "common/shared/ceiling.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) ceiling_atomics(Params p, World w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (i >= p.n) return;
  atomicAdd(&w.count[scattered(i, p.n)], 1u);
}

Entry ceiling_atomics_kernel(uint, Variant) { return reinterpret_cast<Entry>(&ceiling_atomics); }

}  // namespace spherepair
