// SPDX-License-Identifier: MIT
// One thread per sphere of a sample: copies it, at equal strides of the sphere index.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) sample(Params p, KernelBuffers buf) {
  uint k = group_index(p) * BLOCK + threadIdx.x;
  buf.sorted[k] = buf.position[uint(uint64_t(k) * uint64_t(p.n) / uint64_t(group_count() * BLOCK))];
}

Entry sample_kernel(uint, Variant) { return reinterpret_cast<Entry>(&sample); }

}  // namespace spherepair
