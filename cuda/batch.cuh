// SPDX-License-Identifier: MIT
// A group draws BATCH spheres at a time: one thread finds out where each is to be tried, and as few of them are,
// WALKERS threads then try each of those.
#pragma once

#include "visible.cuh"

namespace spherepair {

// All threads of the group call it; `exists`: there is a sphere at this one's place.
__device__ inline void draw_batch(const Params& p, const World& w, const View& v, uint place, bool exists) {
  __shared__ vec4 walk_seen[BATCH];  // of a Walk, packed: many groups are to have room
  __shared__ uvec4 walk_left[BATCH];
  __shared__ uint walk_count;
  uint lane = threadIdx.x;
  if (lane == 0u) walk_count = 0u;
  __syncthreads();
  if (exists) {
    Walk walk = walk_of(p, w, v, place, true);
    if (walk.box.width * walk.box.height > WALK_ALONE) {
      uint entry = atomicAdd(&walk_count, 1u);
      uvec2 box = words_of(walk.box);
      walk_seen[entry] = walk.seen;
      walk_left[entry] = uvec4{box.x, box.y, walk.nearest, walk.sphere};
    } else {
      draw_walk(w, v, walk, 0u, 1u, 1u);
    }
  }
  __syncthreads();
  for (uint k = lane / WALKERS; k < walk_count; k += BATCH / WALKERS) {
    uvec4 left = walk_left[k];
    Walk walk = {walk_seen[k], box_from(uvec2{left.x, left.y}), left.z, left.w};
    draw_walk(w, v, walk, lane % WALKERS, WALKERS, WALKERS_ACROSS);
  }
  __syncthreads();  // before the next batch
}

}  // namespace spherepair
