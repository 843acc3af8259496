// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: puts the sphere of an image in the image's place. A pair of two
// images, whose spheres are another pair, becomes the pair (0, 0), which stands for none.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) contact_images(Params p, KernelBuffers buf) {
  uint pairs = p.search.near_pairs;
  for (uint k = group_index(p) * BLOCK + threadIdx.x; k < pairs; k += group_count() * BLOCK) {
    uvec2 pair = buf.near[k];
    if (pair.x >= p.n) buf.near[k] = uvec2{0u, 0u};
    if (pair.x < p.n && pair.y >= p.n) buf.near[k] = uvec2{pair.x, buf.image_of[1u + pair.y - p.n]};
  }
}

Entry contact_images_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_images); }

}  // namespace spherepair
