// SPDX-License-Identifier: MIT
// One thread per sphere adds to the count of a scattered other: what remains is the rate of atomics without a result.
#include "common/shared/peak_rate.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) peak_atomics(Params p, KernelBuffers w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (i >= p.n) return;
  atomicAdd(&w.count[scattered(i, p.n)], 1u);
}

Entry peak_atomics_kernel(uint, Variant) { return reinterpret_cast<Entry>(&peak_atomics); }

}  // namespace spherepair
