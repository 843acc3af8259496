// SPDX-License-Identifier: MIT
// A group draws as many spheres at a time as it has threads: one thread finds out where each is to be tried, and as few
// of them are, WALKERS threads then try each of those.
#pragma once

#include "cuda/draw/visible.cuh"

namespace spherepair {

// All threads of the group call it; `exists`: there is a sphere at this one's place.
template <uint block>
__device__ inline void draw_batch(const Params& p, const KernelBuffers& w, const View& v, uint sorted_index,
                                  bool exists) {
  // Box, nearest and place: many groups are to have room, so the rest is looked up again.
  __shared__ uvec4 walks[block];
  __shared__ uint walk_count;
  uint lane = threadIdx.x;
  if (lane == 0u) walk_count = 0u;
  __syncthreads();
  if (exists) {
    Walk walk = walk_of(p, w, v, sorted_index, true);
    if (walk.box.width * walk.box.height > WALK_ALONE) {
      uint entry = atomicAdd(&walk_count, 1u);
      uvec2 box = words_of(walk.box);
      walks[entry] = uvec4{box.x, box.y, walk.nearest, sorted_index};
    } else {
      draw_walk(w, v, walk, 0u, 1u, 1u);
    }
  }
  __syncthreads();
  for (uint k = lane / WALKERS; k < walk_count; k += block / WALKERS) {
    uvec4 found = walks[k];
    vec4 sphere = w.position[found.w];
    Walk walk = {in_camera(with_radius(p, sphere), v), box_from(uvec2{found.x, found.y}), found.z,
                 sphere_index(p, w, sphere, found.w)};
    draw_walk(w, v, walk, lane % WALKERS, WALKERS, WALKERS_ACROSS);
  }
  __syncthreads();  // before the next batch
}

}  // namespace spherepair
