// SPDX-License-Identifier: MIT
// A group draws as many spheres at a time as it has threads: one thread finds out where each is to be tried, and as few
// of them are, WALKERS threads then try each of those.
#include "shaders/draw/visible.glsl"

// Box, nearest and place: many groups are to have room, so the rest is looked up again.
shared uvec4 walks[BLOCK];
shared uint walk_count;

// All threads of the group call it; `exists`: there is a sphere at this one's place.
void draw_batch(uint sorted_index, bool exists) {
  uint lane = gl_LocalInvocationID.x;
  if (lane == 0u) walk_count = 0u;
  barrier();
  if (exists) {
    Walk walk = walk_of(sorted_index, true);
    if (walk.box.width * walk.box.height > WALK_ALONE) {
      uint entry = atomicAdd(walk_count, 1u);
      walks[entry] = uvec4(words_of(walk.box), walk.nearest, sorted_index);
    } else {
      draw_walk(walk, 0u, 1u, 1u);
    }
  }
  barrier();
  for (uint k = lane / WALKERS; k < walk_count; k += BLOCK / WALKERS) {
    uvec4 found = walks[k];
    vec4 sphere = position[found.w];
    Walk walk = {in_camera(with_radius(sphere), v), box_from(found.xy), found.z, sphere_index(sphere, found.w)};
    draw_walk(walk, lane % WALKERS, WALKERS, WALKERS_ACROSS);
  }
  barrier();  // before the next batch
}
