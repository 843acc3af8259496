#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out the spheres that the last picture showed; one thread per sphere.
#include "batch.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint count = drawn[DRAWN_SEEN + v.turn];
  for (uint first = group_index() * BATCH; first < count; first += group_count() * BATCH) {
    uint k = first + gl_LocalInvocationID.x;
    draw_batch(k < count ? seen_list[k] : 0u, k < count);
  }
}
