// SPDX-License-Identifier: MIT
// The picture's buffers, and how a sphere is put at a pixel: of all that the pixel's ray meets, the least depth stays,
// and of equal ones the least number, whatever the order of the threads.
#include "buffers.glsl"
#include "draw.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
#ifdef ATOMICS_64
layout(std430, binding = SLOT_VISIBLE) restrict coherent buffer VisibleBuffer { uint64_t visible[]; };
#else
layout(std430, binding = SLOT_VISIBLE) restrict coherent buffer VisibleBuffer { uint visible[]; };
#endif
layout(std430, binding = SLOT_TILE) restrict buffer TileBuffer { uvec2 tile[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };

void count_drawn(uint word) {
  if (v.counting != 0u && v.pass == PASS_DEPTH) atomicAdd(drawn[word], 1u);
}

void draw_at(uint px, uint py, vec4 seen, uint sphere) {
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
  uint pixel = py * v.width + px;
#ifdef ATOMICS_64
  uint64_t mine = (uint64_t(float_bits(depth)) << 32) | uint64_t(sphere);
  if (mine < visible[pixel]) atomicMin(visible[pixel], mine);
#else
  uint bits = float_bits(depth);
  if (v.pass == PASS_DEPTH && bits < visible[2u * pixel + 1u]) atomicMin(visible[2u * pixel + 1u], bits);
  if (v.pass == PASS_ID && bits == visible[2u * pixel + 1u]) atomicMin(visible[2u * pixel], sphere);
#endif
}
