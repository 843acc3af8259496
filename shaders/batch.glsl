// SPDX-License-Identifier: MIT
// A group draws BATCH spheres at a time: one thread finds out where each is to be tried, and as few of them are,
// WALKERS threads then try each of those.
#include "visible.glsl"

shared vec4 walk_seen[BATCH];  // of a Walk, packed: many groups are to have room
shared uvec4 walk_left[BATCH];
shared uint walk_count;

// All threads of the group call it; `exists`: there is a sphere at this one's place.
void draw_batch(uint place, bool exists) {
  uint lane = gl_LocalInvocationID.x;
  if (lane == 0u) walk_count = 0u;
  barrier();
  if (exists) {
    Walk walk = walk_of(place, true);
    if (walk.box.width * walk.box.height > WALK_ALONE) {
      uint entry = atomicAdd(walk_count, 1u);
      walk_seen[entry] = walk.seen;
      walk_left[entry] = uvec4(words_of(walk.box), walk.nearest, walk.sphere);
    } else {
      draw_walk(walk, 0u, 1u, 1u);
    }
  }
  barrier();
  for (uint k = lane / WALKERS; k < walk_count; k += BATCH / WALKERS) {
    uvec4 left = walk_left[k];
    Walk walk = {walk_seen[k], box_from(left.xy), left.z, left.w};
    draw_walk(walk, lane % WALKERS, WALKERS, WALKERS_ACROSS);
  }
  barrier();  // before the next batch
}
