// SPDX-License-Identifier: MIT
// A group draws BATCH spheres at a time: one thread finds out where each is to be tried, and as few of them are,
// WALKERS threads then try each of those.
#include "visible.glsl"

shared Walk walks[BATCH];
shared uint walk_count;

// All threads of the group call it; `exists`: there is a sphere at this one's place.
void draw_batch(uint place, bool exists) {
  uint lane = gl_LocalInvocationID.x;
  if (lane == 0u) walk_count = 0u;
  barrier();
  if (exists) {
    Walk walk = walk_of(place, true);
    if (walk.box.width * walk.box.height > WALK_ALONE) {
      walks[atomicAdd(walk_count, 1u)] = walk;
    } else {
      draw_walk(walk, 0u, 1u, 1u);
    }
  }
  barrier();
  for (uint k = lane / WALKERS; k < walk_count; k += BATCH / WALKERS)
    draw_walk(walks[k], lane % WALKERS, WALKERS, WALKERS_ACROSS);
  barrier();  // before the next batch
}
