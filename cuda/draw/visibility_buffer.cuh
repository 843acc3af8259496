// SPDX-License-Identifier: MIT
// Rasterises a sphere into the visibility buffer: each pixel keeps the least depth of all spheres that its ray hits,
// and of equal depths the least sphere index, in whatever order threads run.
#pragma once

#include "cuda/draw/hiz.cuh"

#ifndef VISIBLE_LOAD
#define VISIBLE_LOAD __ldcg
#endif

namespace spherepair {

__device__ inline void count_drawn(const KernelBuffers& buf, const View& v, uint word) {
  if (v.counting != 0u && v.pass == PASS_DEPTH) atomicAdd(&buf.drawn[word], 1u);
}

// Draws a sphere in one pixel. nearest: least_depth_of the sphere; if the pixel already shows something nearer, the ray
// is not intersected.
__device__ inline void draw_at(const KernelBuffers& buf, const View& v, uint px, uint py, vec4 seen, uint nearest,
                               uint sphere) {
  uint pixel = py * v.width + px;
  unsigned long long* visible = reinterpret_cast<unsigned long long*>(buf.visible);
  unsigned long long there = VISIBLE_LOAD(&visible[pixel]);
  if (uint(there >> 32) < nearest) return;
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
  unsigned long long mine = (uint64_t(float_bits(depth)) << 32) | uint64_t(sphere);
  if (mine < there) atomicMin(&visible[pixel], mine);
}

__device__ inline void cut_into_tiles(const KernelBuffers& buf, const View& v, uint sphere, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(&buf.drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) buf.tile[first + k] = uvec2{sphere, k};
}

// SLOT_SEEN_LIST, and the four bits that say for how many frames a sphere remains in it.
__device__ inline uint first_seen(const Params& p, uint turn) { return turn * (p.n + 1u); }
__device__ inline uint shift_in_word(uint seen) { return 4u * (seen % 8u); }
__device__ inline uint left_of(const KernelBuffers& buf, uint seen) {
  return buf.seen_left[seen / 8u] >> shift_in_word(seen) & 15u;
}

// The pixels that a sphere may cover: an empty box if it is culled or left to draw_tiles.
struct Footprint {
  vec4 seen;
  Box box;
  uint nearest, sphere;
};

// Returns the footprint of a sphere. It is skipped if it is outside the frustum, between pixel centres, hidden or drawn
// before, and cut into tiles if it is large. One of its threads, which `leads`, does that and copies its contacts from
// cell order.
__device__ inline Footprint footprint_of(const Params& p, const KernelBuffers& buf, const View& v, uint k, bool leads) {
  vec4 found = buf.position[k];
  vec4 seen = in_camera(with_radius(p, found), v);
  Footprint footprint = {seen, {0u, 0u, 0u, 0u}, 0u, 0u};
  Box box = footprint.box;
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  if (none && leads) count_drawn(buf, v, seen.w == 0.0f ? DRAWN_UNDRAWABLE : DRAWN_UNSEEN);
  if (none) return footprint;
  bool rest = v.occlusion != 0u && v.phase != PHASE_SEEN;
  footprint.nearest = least_depth_of(seen, box, v);
  bool testable = rest && box.width * box.height > PIXELS_UNTESTED;
  bool hidden = testable && is_hidden(buf, v, box, footprint.nearest, level_for(box));
  if (hidden) count_drawn(buf, v, DRAWN_HIDDEN);
  if (hidden) return footprint;
  footprint.sphere = sphere_index(p, buf, found, k);
  bool unsorts = index_source(p) != 0u && v.colour_by == COLOUR_BY_CONTACTS;
  if (leads && unsorts) buf.count[footprint.sphere] = buf.sorted_count[k];
  if (rest && left_of(buf, footprint.sphere) != 0u) return footprint;
  bool large = is_large(box, v);
  if (leads) count_drawn(buf, v, large ? DRAWN_LARGE : DRAWN_SMALL);
  if (!large) footprint.box = box;
  if (large && leads) cut_into_tiles(buf, v, footprint.sphere, box);
  return footprint;
}

// Draws one thread's share of a footprint.
__device__ inline void draw_footprint(const KernelBuffers& buf, const View& v, Footprint footprint, uint lane,
                                      uint lanes, uint across) {
  Box box = footprint.box;
#pragma unroll 1  // CUDA only: a box has few pixels, and unrolled loops take 39 registers in place of 29
  for (uint y = box.y + lane / across; y < box.y + box.height; y += lanes / across)
#pragma unroll 1  // CUDA only: as above
    for (uint x = box.x + lane % across; x < box.x + box.width; x += across)
      draw_at(buf, v, x, y, footprint.seen, footprint.nearest, footprint.sphere);
}

}  // namespace spherepair
