#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere; a fixed number of groups loops over the spheres visible in recent frames, and draws them.
#define VISIBLE_ACCESS  // a stale depth only costs time
#include "shaders/draw/append.glsl"
#include "shaders/draw/batch.glsl"

layout(local_size_x = BLOCK) in;

// Whether the sphere stays in the list; it leaves after some frames in which it is not visible.
bool stays(uint sphere) {
  uint left = left_of(sphere);
  uint fades = min(left, SEEN_FADES);
  atomicAdd(seen_left[sphere / 8u], 0u - (fades << shift_in_word(sphere)));
  return left > fades;
}

void main() {
  uint total = drawn[DRAWN_SEEN + v.turn];
  uint next = 1u - v.turn;
  uint at_once = min(uint(BLOCK), total / group_count() + 1u);  // few spheres are spread over all groups
  for (uint first = group_index() * at_once; first < total; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x;
    bool exists = gl_LocalInvocationID.x < at_once && k < total;
    uint sphere = exists ? seen_list[first_seen(v.turn) + k] : 0u;
    bool kept = exists && v.pass == PASS_DEPTH && stays(sphere);
    uint at = append_index(DRAWN_SEEN + next, kept);
    if (kept) seen_list[first_seen(next) + at] = sphere;
    draw_batch(sphere, exists);
  }
}
