#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out the spheres that the last pictures showed; one thread per
// sphere.
#include "listing.glsl"

layout(local_size_x = BLOCK) in;

// Whether it stays in the list; what is not seen again fades.
bool stays(uint seen) {
  uint left = left_of(seen);
  uint fades = min(left, v.occlusion == 1u ? SEEN_FADES : TOGETHER_FADES);
  atomicAdd(seen_left[seen / 8u], 0u - (fades << shift_in_word(seen)));
  return left > fades;
}

void main() {
  uint total = drawn[DRAWN_SEEN + v.turn] * v.occlusion;
  uint next = 1u - v.turn;
  uint lane = gl_LocalInvocationID.x % v.lanes;
  uint at_once = BATCH / v.lanes;
  for (uint first = group_index() * at_once; first < total; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x / v.lanes;
    uint seen = k < total ? seen_list[first_seen(v.turn) + k / v.occlusion] : 0u;
    uint sphere = seen * v.occlusion + k % v.occlusion;
    bool leads = k < total && lane == 0u && k % v.occlusion == 0u;
    bool kept = leads && v.pass == PASS_DEPTH && stays(seen);
    uint place = place_in_list(DRAWN_SEEN + next, kept);
    if (kept) seen_list[first_seen(next) + place] = seen;
    if (k < total && sphere < p.n) draw_walk(walk_of(sphere, lane == 0u), lane, v.lanes, lanes_across(v));
  }
}
