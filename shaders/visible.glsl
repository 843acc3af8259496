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

// `nearest`: least_depth_of the sphere; where something nearer is seen already, the ray's meeting is not asked for.
void draw_at(uint px, uint py, vec4 seen, uint nearest, uint sphere) {
  uint pixel = py * v.width + px;
#ifdef ATOMICS_64
  uint64_t there = visible[pixel];
  if (uint(there >> 32) < nearest) return;
#else
  uint there = visible[2u * pixel + 1u];
  if (there < nearest) return;
#endif
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
#ifdef ATOMICS_64
  uint64_t mine = (uint64_t(float_bits(depth)) << 32) | uint64_t(sphere);
  if (mine < there) atomicMin(visible[pixel], mine);
#else
  uint bits = float_bits(depth);
  if (v.pass == PASS_DEPTH && bits < there) atomicMin(visible[2u * pixel + 1u], bits);
  if (v.pass == PASS_ID && bits == there) atomicMin(visible[2u * pixel], sphere);
#endif
}

void cut_into_tiles(uint place, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) tile[first + k] = uvec2(place, k);
}

// The work of one of the v.lanes threads of a sphere. It is passed over when it is out of view or between the pixels'
// centres, tried at every pixel of its box when that is small, and cut into tiles for draw_tiles when it is large.
void draw_sphere(uint place, uint lane) {
  vec4 seen = in_camera(position[place], v);
  Box box = Box(0u, 0u, 0u, 0u);
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  bool large = !none && is_large(box, v);
  if (lane == 0u)
    count_drawn(seen.w == 0.0f ? DRAWN_UNDRAWABLE : none ? DRAWN_UNSEEN : large ? DRAWN_LARGE : DRAWN_SMALL);
  if (none) return;
  if (large) {
    if (lane == 0u) cut_into_tiles(place, box);
    return;
  }
  uint sphere = p.in_cells != 0u ? id[place] : place;
  uint nearest = least_depth_of(seen);
  uint across = v.lanes == 1u ? 1u : uint(LANES_ACROSS);
  uint down = v.lanes / across;
  for (uint y = box.y + lane / across; y < box.y + box.height; y += down)
    for (uint x = box.x + lane % across; x < box.x + box.width; x += across) draw_at(x, y, seen, nearest, sphere);
}
