#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups shares out the spheres that the last pictures showed; one thread per sphere.
#define VISIBLE_ACCESS  // what was seen long ago hides as well
#include "shaders/draw/batch.glsl"
#include "shaders/draw/listing.glsl"

layout(local_size_x = BLOCK) in;

// Whether it stays in the list; what is not seen again fades.
bool stays(uint sphere) {
  uint left = left_of(sphere);
  uint fades = min(left, SEEN_FADES);
  atomicAdd(seen_left[sphere / 8u], 0u - (fades << shift_in_word(sphere)));
  return left > fades;
}

void main() {
  uint total = drawn[DRAWN_SEEN + v.turn];
  uint next = 1u - v.turn;
  uint at_once = min(uint(BLOCK), total / group_count() + 1u);  // no group is left without while others have many
  for (uint first = group_index() * at_once; first < total; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x;
    bool exists = gl_LocalInvocationID.x < at_once && k < total;
    uint sphere = exists ? seen_list[first_seen(v.turn) + k] : 0u;
    bool kept = exists && v.pass == PASS_DEPTH && stays(sphere);
    uint sorted_index = index_in_list(DRAWN_SEEN + next, kept);
    if (kept) seen_list[first_seen(next) + sorted_index] = sphere;
    draw_batch(sphere, exists);
  }
}
