// SPDX-License-Identifier: MIT
// Draws as many spheres at a time as a group has threads: one thread computes the footprint of each; since few are
// visible, BOX_THREADS threads then share the pixels of each visible one.
#pragma once

#include "cuda/draw/visibility_buffer.cuh"

namespace spherepair {

// Draws a sphere for each thread with `exists`. All threads of the group must call it.
template <uint BLOCK>
__device__ inline void draw_batch(const Params& p, const KernelBuffers& buf, const View& v, uint k, bool exists) {
  // Box, nearest and index: 16 bytes, for occupancy; the rest is looked up again.
  __shared__ uvec4 queue[BLOCK];
  __shared__ uint queued;
  uint lane = threadIdx.x;
  if (lane == 0u) queued = 0u;
  __syncthreads();
  if (exists) {
    Footprint footprint = footprint_of(p, buf, v, k, true);
    if (footprint.box.width * footprint.box.height > PIXELS_ALONE) {
      uint entry = atomicAdd(&queued, 1u);
      uvec2 box = words_of(footprint.box);
      queue[entry] = uvec4{box.x, box.y, footprint.nearest, k};
    } else {
      draw_footprint(buf, v, footprint, 0u, 1u, 1u);
    }
  }
  __syncthreads();
  for (uint q = lane / BOX_THREADS; q < queued; q += BLOCK / BOX_THREADS) {
    uvec4 found = queue[q];
    vec4 sphere = buf.position[found.w];
    Footprint footprint = {in_camera(with_radius(p, sphere), v), box_from(uvec2{found.x, found.y}), found.z,
                           sphere_index(p, buf, sphere, found.w)};
    draw_footprint(buf, v, footprint, lane % BOX_THREADS, BOX_THREADS, BOX_THREADS_ACROSS);
  }
  __syncthreads();  // before the next batch
}

}  // namespace spherepair
