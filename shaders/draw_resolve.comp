#version 450
// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: the light on the sphere that is seen there, or the background.
#include "buffers.glsl"
#include "draw.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_VISIBLE) restrict readonly buffer VisibleBuffer { uvec2 visible[]; };
layout(std430, binding = SLOT_IMAGE) restrict writeonly buffer ImageBuffer { uint image[]; };
layout(local_size_x = BLOCK) in;

void main() {
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index() * PIXELS_EACH + k) * BLOCK + gl_LocalInvocationID.x;
    if (pixel >= v.width * v.height) return;
    uvec2 seen = visible[pixel];
    uint colour = lit(v.background, 1.0f);
    if (seen.y != 0xFFFFFFFFu) {
      Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
      colour = shade(in_camera(position[seen.x], v), ray, bits_float(seen.y), count[seen.x], v);
    }
    image[pixel] = colour;
  }
}
