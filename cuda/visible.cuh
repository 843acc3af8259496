// SPDX-License-Identifier: MIT
// The picture's buffers, and how a sphere is put at a pixel: of all that the pixel's ray meets, the least depth stays,
// and of equal ones the least number, whatever the order of the threads.
#pragma once

#include "draw.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline void count_drawn(const World& w, const View& v, uint word) {
  if (v.counting != 0u && v.pass == PASS_DEPTH) atomicAdd(&w.drawn[word], 1u);
}

// `nearest`: least_depth_of the sphere; where something nearer is seen already, the ray's meeting is not asked for.
__device__ inline void draw_at(const World& w, const View& v, uint px, uint py, vec4 seen, uint nearest, uint sphere) {
  uint pixel = py * v.width + px;
  unsigned long long* visible = reinterpret_cast<unsigned long long*>(w.visible);
  unsigned long long there = __ldcg(&visible[pixel]);
  if (uint(there >> 32) < nearest) return;
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
  unsigned long long mine = (uint64_t(float_bits(depth)) << 32) | uint64_t(sphere);
  if (mine < there) atomicMin(&visible[pixel], mine);
}

__device__ inline void cut_into_tiles(const World& w, const View& v, uint place, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(&w.drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) w.tile[first + k] = uvec2{place, k};
}

// The work of one of the v.lanes threads of a sphere. It is passed over when it is out of view or between the pixels'
// centres, tried at every pixel of its box when that is small, and cut into tiles for draw_tiles when it is large.
__device__ inline void draw_sphere(const Params& p, const World& w, const View& v, uint place, uint lane) {
  vec4 seen = in_camera(w.position[place], v);
  Box box = {0u, 0u, 0u, 0u};
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  bool large = !none && is_large(box, v);
  if (lane == 0u)
    count_drawn(w, v, seen.w == 0.0f ? DRAWN_UNDRAWABLE : none ? DRAWN_UNSEEN : large ? DRAWN_LARGE : DRAWN_SMALL);
  if (none) return;
  if (large) {
    if (lane == 0u) cut_into_tiles(w, v, place, box);
    return;
  }
  uint sphere = p.in_cells != 0u ? w.id[place] : place;
  uint nearest = least_depth_of(seen);
  uint across = v.lanes == 1u ? 1u : uint(LANES_ACROSS);
  uint down = v.lanes / across;
  for (uint y = box.y + lane / across; y < box.y + box.height; y += down)
    for (uint x = box.x + lane % across; x < box.x + box.width; x += across) draw_at(w, v, x, y, seen, nearest, sphere);
}

}  // namespace spherepair
