#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out the spheres that the last pictures showed; one thread per
// sphere.
#include "batch.glsl"
#include "listing.glsl"

layout(local_size_x = BLOCK) in;

// Whether it stays in the list; what is not seen again fades.
bool stays(uint sphere) {
  uint left = left_of(sphere);
  atomicAdd(seen_left[sphere / 8u], 0u - (min(left, SEEN_FADES) << shift_in_word(sphere)));
  return left > SEEN_FADES;
}

void main() {
  uint count = drawn[DRAWN_SEEN + v.turn];
  uint next = 1u - v.turn;
  for (uint first = group_index() * BATCH; first < count; first += group_count() * BATCH) {
    uint k = first + gl_LocalInvocationID.x;
    uint sphere = k < count ? seen_list[v.turn * p.n + k] : 0u;
    bool kept = k < count && v.pass == PASS_DEPTH && stays(sphere);
    uint place = place_in_list(DRAWN_SEEN + next, kept);
    if (kept) seen_list[next * p.n + place] = sphere;
    draw_batch(sphere, k < count);
  }
}
