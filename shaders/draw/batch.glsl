// SPDX-License-Identifier: MIT
// Draws as many spheres at a time as a group has threads: one thread computes the footprint of each; since few are
// visible, BOX_THREADS threads then share the pixels of each visible one.
#include "shaders/draw/visibility_buffer.glsl"

// Box, nearest and index: 16 bytes, for occupancy; the rest is looked up again.
shared uvec4 queue[BLOCK];
shared uint queued;

// Draws a sphere for each thread with `exists`. All threads of the group must call it.
void draw_batch(uint k, bool exists) {
  uint lane = gl_LocalInvocationID.x;
  if (lane == 0u) queued = 0u;
  barrier();
  if (exists) {
    Footprint footprint = footprint_of(k, true);
    if (footprint.box.width * footprint.box.height > PIXELS_ALONE) {
      uint entry = atomicAdd(queued, 1u);
      uvec2 box = words_of(footprint.box);
      queue[entry] = uvec4(box.x, box.y, footprint.nearest, k);
    } else {
      draw_footprint(footprint, 0u, 1u, 1u);
    }
  }
  barrier();
  for (uint q = lane / BOX_THREADS; q < queued; q += BLOCK / BOX_THREADS) {
    uvec4 found = queue[q];
    vec4 sphere = position[found.w];
    Footprint footprint = {in_camera(with_radius(sphere), v), box_from(uvec2(found.x, found.y)), found.z,
                           sphere_index(sphere, found.w)};
    draw_footprint(footprint, lane % BOX_THREADS, BOX_THREADS, BOX_THREADS_ACROSS);
  }
  barrier();  // before the next batch
}
