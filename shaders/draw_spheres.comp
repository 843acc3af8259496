#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: it is drawn, unless it is large, which draw_tiles then does.
#include "visible.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint place = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (place < p.n) draw_sphere(place);
}
