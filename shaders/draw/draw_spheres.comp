#version 450
// SPDX-License-Identifier: MIT
// One thread, or LANES threads, per sphere: it is drawn, unless it is large, which draw_tiles then does.
#include "shaders/draw/visible.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * (BLOCK / v.lanes) + gl_LocalInvocationID.x / v.lanes;
  if (k >= p.n) return;
  uint lane = gl_LocalInvocationID.x % v.lanes;
  Walk walk = walk_of(place_in_turn(k, p.n, v), lane == 0u);
  draw_walk(walk, lane, v.lanes, lanes_across(v));
}
