// SPDX-License-Identifier: MIT
// The picture's buffers, and how a sphere is put at a pixel: of all that the pixel's ray meets, the least depth stays,
// and of equal ones the least number, whatever the order of the threads.
#pragma once

#include "cuda/draw/pyramid.cuh"

#ifndef VISIBLE_LOAD
#define VISIBLE_LOAD __ldcg
#endif

namespace spherepair {

__device__ inline void count_drawn(const KernelBuffers& w, const View& v, uint word) {
  if (v.counting != 0u && v.pass == PASS_DEPTH) atomicAdd(&w.drawn[word], 1u);
}

// `nearest`: least_depth_of the sphere; where something nearer is seen already, the ray's meeting is not asked for.
__device__ inline void draw_at(const KernelBuffers& w, const View& v, uint px, uint py, vec4 seen, uint nearest,
                               uint sphere) {
  uint pixel = py * v.width + px;
  unsigned long long* visible = reinterpret_cast<unsigned long long*>(w.visible);
  unsigned long long there = VISIBLE_LOAD(&visible[pixel]);
  if (uint(there >> 32) < nearest) return;
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
  unsigned long long mine = (uint64_t(float_bits(depth)) << 32) | uint64_t(sphere);
  if (mine < there) atomicMin(&visible[pixel], mine);
}

__device__ inline void cut_into_tiles(const KernelBuffers& w, const View& v, uint sphere, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(&w.drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) w.tile[first + k] = uvec2{sphere, k};
}

// The list of those seen and, in four bits, for how long each still stands there.
__device__ inline uint first_seen(const Params& p, uint turn) { return turn * (p.n + 1u); }
__device__ inline uint shift_in_word(uint seen) { return 4u * (seen % 8u); }
__device__ inline uint left_of(const KernelBuffers& w, uint seen) {
  return w.seen_left[seen / 8u] >> shift_in_word(seen) & 15u;
}

// Where a sphere is to be tried: an empty box where that is nowhere, or draw_tiles does it.
struct Walk {
  vec4 seen;
  Box box;
  uint nearest, sphere;
};

// It is passed over when it is out of view, between the pixels' centres, hidden or drawn before, and cut into tiles
// when it is large. One of its threads leads. The contacts of whatever may be seen come along from the cell order.
__device__ inline Walk walk_of(const Params& p, const KernelBuffers& w, const View& v, uint sorted_index, bool leads) {
  vec4 found = w.position[sorted_index];
  vec4 seen = in_camera(with_radius(p, found), v);
  Walk walk = {seen, {0u, 0u, 0u, 0u}, 0u, 0u};
  Box box = walk.box;
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  if (none && leads) count_drawn(w, v, seen.w == 0.0f ? DRAWN_UNDRAWABLE : DRAWN_UNSEEN);
  if (none) return walk;
  bool rest = v.occlusion != 0u && v.phase != PHASE_SEEN;
  walk.nearest = least_depth_of(seen, box, v);
  bool asks = rest && box.width * box.height > WALK_UNTESTED;
  bool hidden = asks && is_hidden(w, v, box, walk.nearest, level_for(box));
  if (hidden) count_drawn(w, v, DRAWN_HIDDEN);
  if (hidden) return walk;
  walk.sphere = sphere_index(p, w, found, sorted_index);
  if (leads && p.in_cells != 0u) w.count[walk.sphere] = w.sorted_count[sorted_index];
  if (rest && left_of(w, walk.sphere) != 0u) return walk;
  bool large = is_large(box, v);
  if (leads) count_drawn(w, v, large ? DRAWN_LARGE : DRAWN_SMALL);
  if (!large) walk.box = box;
  if (large && leads) cut_into_tiles(w, v, walk.sphere, box);
  return walk;
}

// The work of one of the threads that share the pixels of a walk.
__device__ inline void draw_walk(const KernelBuffers& w, const View& v, Walk walk, uint lane, uint lanes, uint across) {
  Box box = walk.box;
#pragma unroll 1  // boxes are small, and a warp has several
  for (uint y = box.y + lane / across; y < box.y + box.height; y += lanes / across)
#pragma unroll 1
    for (uint x = box.x + lane % across; x < box.x + box.width; x += across)
      draw_at(w, v, x, y, walk.seen, walk.nearest, walk.sphere);
}

}  // namespace spherepair
