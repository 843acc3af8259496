// SPDX-License-Identifier: MIT
// Declares what every kernel uses: the buffers of layout.h, the index of its group, and the index of a sphere.
#pragma once

#include <type_traits>

#include "cuda/kernels.h"

namespace spherepair {

// CUDA only from here: finding the instance of a template; GLSL compiles the text for each variant
template <auto value>
using Constant = std::integral_constant<decltype(value), value>;

// Calls pick(block, equal_radii, listed) with all three as constants.
template <int block, typename Pick>
Entry pick_variant(Variant variant, Pick pick) {
  constexpr Constant<block> size;
  constexpr Constant<true> yes;
  constexpr Constant<false> no;
  if (variant.equal_radii) return variant.listed ? pick(size, yes, yes) : pick(size, yes, no);
  return variant.listed ? pick(size, no, yes) : pick(size, no, no);
}
template <typename Pick>
Entry pick_kernel(uint block, Variant variant, Pick pick) {
  switch (block) {
    case 32:
      return pick_variant<32>(variant, pick);
    case 64:
      return pick_variant<64>(variant, pick);
    case 128:
      return pick_variant<128>(variant, pick);
    case 256:
      return pick_variant<256>(variant, pick);
    case 512:
      return pick_variant<512>(variant, pick);
    case 1024:
      return pick_variant<1024>(variant, pick);
  }
  return nullptr;
}

// Does the same with groups that are smaller than a warp.
template <typename Pick>
Entry pick_small_kernel(uint block, Variant variant, Pick pick) {
  if (block == 8) return pick_variant<8>(variant, pick);
  if (block == 16) return pick_variant<16>(variant, pick);
  return pick_kernel(block, variant, pick);
}
// until here

// Return the index of this group and the number of groups, however the dispatch is folded and sliced.
__device__ inline uint group_index(const Params& p) { return p.first_group + blockIdx.x + gridDim.x * blockIdx.y; }
__device__ inline uint group_count() { return gridDim.x * gridDim.y; }

__device__ inline uint index_source(const Params& p) { return p.indices; }  // CUDA only: known at run time

// Return the index of a sphere found at index k of the launch's order, and the sphere with its radius. With INDEX_IN_W,
// w holds the index instead of the radius, whichever variant of a kernel reads it.
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

// CUDA only from here: OpenGL and Vulkan have no programmatic dependent launch
// Waits for the previous launch, in a kernel that may begin before that has ended (Call::early), and then sees its
// writes. A kernel that needs nothing of the previous launch waits at its own end, so that the next launch need only
// wait for this one; what it reads was written before the previous launch began.
__device__ inline void grid_dependency_sync() {
#if __CUDA_ARCH__ >= 900
  cudaGridDependencySynchronize();
#endif
}
// Lets the next launch begin once every group has called this.
__device__ inline void trigger_dependent_launch() {
#if __CUDA_ARCH__ >= 900
  cudaTriggerProgrammaticLaunchCompletion();
#endif
}
// At a kernel's begin: waits for the previous launch if it may still run, and lets the next one get ready.
__device__ inline void wait_first(const Params& p) {
  if (p.waits_first == 0u) return;
  grid_dependency_sync();
  trigger_dependent_launch();
}
// until here

}  // namespace spherepair
