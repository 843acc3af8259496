#version 450
// SPDX-License-Identifier: MIT
// One thread, or LANES threads, per sphere: draws it, or leaves it to draw_tiles if it is large.
#include "shaders/draw/visibility_buffer.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * (BLOCK / v.lanes) + gl_LocalInvocationID.x / v.lanes;
  if (k >= p.n) return;
  uint lane = gl_LocalInvocationID.x % v.lanes;
  Footprint footprint = footprint_of(front_to_back(k, p.n, v), lane == 0u);
  draw_footprint(footprint, lane, v.lanes, lanes_across(v));
}
