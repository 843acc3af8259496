#version 450
// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: clears the visibility buffer and lists the spheres that were visible in it. Not
// needed if draw_resolve cleared the previous frame's pixels and there were as many.
#include "shaders/draw/visible_list.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (group_index() == 0u && lane < DRAWN_WORDS && lane != DRAWN_SEEN + v.turn) drawn[lane] = 0u;
  begin_list();
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index() * PIXELS_EACH + k) * BLOCK + lane;
    if (pixel < v.width * v.height) clear_pixel(pixel);
  }
  end_list(v.turn);
}
