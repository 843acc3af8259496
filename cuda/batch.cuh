// SPDX-License-Identifier: MIT
// A group draws BATCH spheres at a time: one thread finds out where each is to be tried, and as few of them are,
// WALKERS threads then try each of those.
#pragma once

#include "visible.cuh"

namespace spherepair {

// All threads of the group call it; `exists`: there is a sphere at this one's place.
__device__ inline void draw_batch(const Params& p, const World& w, const View& v, uint place, bool exists) {
  __shared__ Walk walks[BATCH];
  __shared__ uint walk_count;
  uint lane = threadIdx.x;
  if (lane == 0u) walk_count = 0u;
  __syncthreads();
  if (exists) {
    Walk walk = walk_of(p, w, v, place, true);
    if (walk.box.width * walk.box.height > WALK_ALONE) {
      walks[atomicAdd(&walk_count, 1u)] = walk;
    } else {
      draw_walk(w, v, walk, 0u, 1u, 1u);
    }
  }
  __syncthreads();
  for (uint k = lane / WALKERS; k < walk_count; k += BATCH / WALKERS)
    draw_walk(w, v, walks[k], lane % WALKERS, WALKERS, WALKERS_ACROSS);
  __syncthreads();  // before the next batch
}

}  // namespace spherepair
