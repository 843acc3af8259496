// SPDX-License-Identifier: MIT
// What every kernel sees: the buffers of layout.h, the index of its group, and the index of a sphere.
#pragma once

#include <type_traits>

#include "cuda/kernels.h"

namespace spherepair {

// CUDA only from here: finding the instance of a template; GLSL compiles the text for each variant
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
// until here

// The index of this group and the number of groups, however the dispatch is folded and sliced.
__device__ inline uint group_index(const Params& p) { return p.first_group + blockIdx.x + gridDim.x * blockIdx.y; }
__device__ inline uint group_count() { return gridDim.x * gridDim.y; }

__device__ inline uint index_source(const Params& p) { return p.indices; }  // CUDA only: known at run time

// The index and the radius of a sphere found at index k of the launch's order. Where INDEX_IN_W, w holds the index in
// place of the radius, whichever variant of a kernel reads it.
__device__ inline uint sphere_index(const Params& p, const KernelBuffers& buf, vec4 found, uint k) {
  if (index_source(p) == INDEX_IN_W) return float_bits(found.w);
  return index_source(p) == INDEX_IN_ID ? buf.id[k] : k;
}
__device__ inline vec4 with_radius(const Params& p, vec4 found) {
  if (index_source(p) == INDEX_IN_W) found.w = p.radius;
  return found;
}

__device__ inline void clear_results(const Params& p, const KernelBuffers& buf, uint i) {
  if (i < p.n) buf.count[i] = 0u;
  if (i < SUMMARY_SLOTS * SUMMARY_WORDS) buf.summary[i] = 0u;
}

// CUDA only from here: OpenGL has no programmatic dependent launch
// Of a launch that may begin before the previous one has ended (KernelCall::early): waits for that, and sees what it
// has written. A kernel that needs nothing of the previous launch waits at its end, so that the next launch need only
// wait for this one; what it reads was written before the previous launch began.
__device__ inline void grid_dependency_sync() {
#if __CUDA_ARCH__ >= 900
  cudaGridDependencySynchronize();
#endif
}
// Once every group has called it, the next launch may begin.
__device__ inline void trigger_dependent_launch() {
#if __CUDA_ARCH__ >= 900
  cudaTriggerProgrammaticLaunchCompletion();
#endif
}
// until here

}  // namespace spherepair
