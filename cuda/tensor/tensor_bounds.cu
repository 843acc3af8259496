// SPDX-License-Identifier: MIT
// TENSOR_BOUNDS_GROUPS groups share the spheres: each writes the box of its finite centres, with its greatest radius.
#include "common/shared/tensor_form.h"
#include "cuda/tensor/box.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;
constexpr float GREATEST = 3.402823466e38f;

__global__ void __launch_bounds__(BLOCK) tensor_bounds(Params p, KernelBuffers buf) {
  __shared__ vec4 low[BLOCK], high[BLOCK];  // CUDA only: box.glsl declares them
  uint lane = threadIdx.x;
  vec4 own_low = {GREATEST, GREATEST, GREATEST, 0.0f};
  vec4 own_high = {-GREATEST, -GREATEST, -GREATEST, 0.0f};
  for (uint i = blockIdx.x * BLOCK + lane; i < p.n; i += gridDim.x * BLOCK) {
    vec4 sphere = buf.position[i];
    vec4 with_radius = {sphere.x, sphere.y, sphere.z, larger(sphere.w, -sphere.w)};
    if (finite_sphere(sphere)) widen(own_low, own_high, sphere, with_radius);
  }
  low[lane] = own_low;
  high[lane] = own_high;
  widen_first<BLOCK>(low, high);  // CUDA only: see above
  vec4* boxes = reinterpret_cast<vec4*>(buf.tile_sum);
  if (lane == 0u) boxes[blockIdx.x] = low[0];
  if (lane == 1u) boxes[TENSOR_BOUNDS_GROUPS + blockIdx.x] = high[0];
}

Entry tensor_bounds_kernel(uint, Variant) { return reinterpret_cast<Entry>(&tensor_bounds); }

}  // namespace spherepair
