// SPDX-License-Identifier: MIT
// One thread per pair of spheres: runs all stages of the predicate; reports the verdict and the stage that decided.
#include "common/shared/exact.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) decide(Params p, KernelBuffers buf) {
  uint k = group_index(p) * BLOCK + threadIdx.x;
  if (k >= p.n) return;
  buf.verdict[k] = verdict_code(
      decide_pair(buf.spheres[2u * k], buf.spheres[2u * k + 1u], p.search.filter_scale, p.search.filter_offset));
}

Entry decide_kernel(uint, Variant) { return reinterpret_cast<Entry>(&decide); }

}  // namespace spherepair
