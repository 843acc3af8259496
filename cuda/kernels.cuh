// SPDX-License-Identifier: MIT
// What all kernel files share.
#pragma once

#include <type_traits>

#include "cuda/kernels.h"

namespace spherepair {

template <auto value>
using Constant = std::integral_constant<decltype(value), value>;

// Calls pick(block, equal_radii, listed) with all three as constants.
template <typename Equal, typename Listed, typename Pick>
Entry pick_block(uint block, Equal equal_radii, Listed listed, Pick pick) {
  switch (block) {
    case 32:
      return pick(Constant<32>{}, equal_radii, listed);
    case 64:
      return pick(Constant<64>{}, equal_radii, listed);
    case 128:
      return pick(Constant<128>{}, equal_radii, listed);
    case 256:
      return pick(Constant<256>{}, equal_radii, listed);
    case 512:
      return pick(Constant<512>{}, equal_radii, listed);
    case 1024:
      return pick(Constant<1024>{}, equal_radii, listed);
  }
  return nullptr;
}
template <typename Equal, typename Pick>
Entry pick_listed(uint block, Equal equal_radii, bool listed, Pick pick) {
  return listed ? pick_block(block, equal_radii, Constant<true>{}, pick)
                : pick_block(block, equal_radii, Constant<false>{}, pick);
}
template <typename Pick>
Entry pick_kernel(uint block, Variant variant, Pick pick) {
  return variant.equal_radii ? pick_listed(block, Constant<true>{}, variant.listed, pick)
                             : pick_listed(block, Constant<false>{}, variant.listed, pick);
}

__device__ inline uint group_index(Params p) { return p.first_group + blockIdx.x + gridDim.x * blockIdx.y; }

__device__ inline uint group_count() { return gridDim.x * gridDim.y; }

// Of whoever was found at a place of the launch's order: the number, and the sphere with its radius.
__device__ inline uint sphere_index(const Params& p, const KernelBuffers& w, vec4 found, uint sorted_index) {
  if (p.in_cells == INDEX_IN_W) return float_bits(found.w);
  return p.in_cells == INDEX_IN_ID ? w.id[sorted_index] : sorted_index;
}
__device__ inline vec4 with_radius(const Params& p, vec4 found) {
  if (p.in_cells == INDEX_IN_W) found.w = p.radius;
  return found;
}

// Of a launch that may begin before the one before it is done (KernelCall::early): waits until it is, and sees what it
// has written. What needs nothing of that waits in the end, so that what comes next need only wait for this one; what
// it reads was written before the launch before began to work.
__device__ inline void grid_dependency_sync() {
#if __CUDA_ARCH__ >= 900
  cudaGridDependencySynchronize();
#endif
}
// Once every group has come here, the next launch may begin.
__device__ inline void trigger_dependent_launch() {
#if __CUDA_ARCH__ >= 900
  cudaTriggerProgrammaticLaunchCompletion();
#endif
}

__device__ inline void clear_results(Params p, KernelBuffers w, uint i) {
  if (i < p.n) w.count[i] = 0u;
  if (i < SUMMARY_SLOTS * SUMMARY_WORDS) w.summary[i] = 0u;
}

}  // namespace spherepair
