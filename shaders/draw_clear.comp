#version 450
// SPDX-License-Identifier: MIT
// One thread per pixel: no sphere is seen yet. The list of clusters that the last picture showed is drawn next.
#include "visible.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint pixel = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (pixel < DRAWN_WORDS && pixel != DRAWN_SEEN + v.turn) drawn[pixel] = 0u;
  if (pixel >= v.width * v.height) return;
#ifdef ATOMICS_64
  visible[pixel] = 0xFFFFFFFFFFFFFFFFul;
#else
  visible[2u * pixel] = 0xFFFFFFFFu;
  visible[2u * pixel + 1u] = 0xFFFFFFFFu;
#endif
}
