// SPDX-License-Identifier: MIT
// One thread per sphere adds to the count of a scattered other one: measures the rate of atomics without a result.
#include "common/shared/peak_rate.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) peak_atomics(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i >= p.n) return;
  atomicAdd(&buf.count[scattered(i, p.n)], 1u);
}

Entry peak_atomics_kernel(uint, Variant) { return reinterpret_cast<Entry>(&peak_atomics); }

}  // namespace spherepair
