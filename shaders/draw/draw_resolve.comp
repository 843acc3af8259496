#version 450
// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: shades the visible sphere or the background. Clears the visibility buffer for the
// next frame, unless it is to be kept.
#include "shaders/draw/visible_list.glsl"

layout(std430, binding = SLOT_IMAGE) restrict writeonly buffer ImageBuffer { uint image[]; };
layout(local_size_x = BLOCK) in;

// Moves a count to the previous frame's, unless it counts the visible spheres that the next frame draws.
void move_counts(uint word) {
  uint stays = DRAWN_SEEN + (v.occlusion != 0u ? 1u - v.turn : v.turn);
  if (word >= DRAWN_WORDS || word == stays) return;
  drawn[DRAWN_WORDS + word] = drawn[word];
  drawn[word] = 0u;
}

void main() {
  bool clears = v.pass != PASS_KEEP;
  uint lane = gl_LocalInvocationID.x;
  if (clears && group_index() == 0u) move_counts(lane);
  bool lists = clears && v.occlusion != 0u;
  if (lists) begin_list();
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index() * PIXELS_EACH + k) * BLOCK + lane;
    if (pixel >= v.width * v.height) break;
    uvec2 seen = seen_at(pixel);
    uint colour = lit(v.background, 1.0f);
    if (seen.y != 0xFFFFFFFFu) {
      Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
      colour = shade(in_camera(position[seen.x], v), ray, bits_float(seen.y), count[seen.x], v);
    }
    image[pixel] = colour;
    if (clears && seen.y != 0xFFFFFFFFu) clear_pixel(pixel);
  }
  if (lists) end_list(1u - v.turn);
}
