// SPDX-License-Identifier: MIT
// One thread per pair of spheres: all stages of the predicate, and which of them decided.
#include "common/shared/exact.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) decide(Params p, KernelBuffers w) {
  uint k = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (k >= p.pairs_to_decide) return;
  w.verdict[k] = verdict_code(decide_pair(w.spheres[2u * k], w.spheres[2u * k + 1u], p.filter_scale, p.filter_offset));
}

Entry decide_kernel(uint, Variant) { return reinterpret_cast<Entry>(&decide); }

}  // namespace spherepair
