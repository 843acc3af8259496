// SPDX-License-Identifier: MIT
// Rasterises a sphere into the visibility buffer: each pixel keeps the least depth of all spheres that its ray hits,
// and of equal depths the least sphere index, in whatever order threads run.
#include "shaders/draw/hiz.glsl"

#ifndef VISIBLE_ACCESS
#define VISIBLE_ACCESS coherent
#endif

// GLSL only from here: a word a pixel for 64-bit atomics, else two
#ifdef ATOMICS_64
layout(std430, binding = SLOT_VISIBLE) restrict VISIBLE_ACCESS buffer VisibleBuffer { uint64_t visible[]; };
#else
layout(std430, binding = SLOT_VISIBLE) restrict VISIBLE_ACCESS buffer VisibleBuffer { uint visible[]; };
#endif
// until here
layout(std430, binding = SLOT_SORTED_COUNT) restrict readonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(std430, binding = SLOT_TILE) restrict buffer TileBuffer { uvec2 tile[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(std430, binding = SLOT_SEEN_LEFT) restrict buffer SeenLeftBuffer { uint seen_left[]; };
layout(std430, binding = SLOT_SEEN_LIST) restrict buffer SeenListBuffer { uint seen_list[]; };

void count_drawn(uint word) {
  if (v.counting != 0u && v.pass == PASS_DEPTH) atomicAdd(drawn[word], 1u);
}

// GLSL only from here: without 64-bit atomics two passes write depth and index
#ifndef ATOMICS_64
void draw_at(uint px, uint py, vec4 seen, uint nearest, uint sphere) {
  uint pixel = py * v.width + px;
  uint there = visible[2u * pixel + 1u];
  if (there < nearest) return;
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
  uint bits = float_bits(depth);
  if (v.pass == PASS_DEPTH && bits < there) atomicMin(visible[2u * pixel + 1u], bits);
  if (v.pass == PASS_ID && bits == there) atomicMin(visible[2u * pixel], sphere);
}
#else
// until here
// Draws a sphere in one pixel. nearest: least_depth_of the sphere; if the pixel already shows something nearer, the ray
// is not intersected.
void draw_at(uint px, uint py, vec4 seen, uint nearest, uint sphere) {
  uint pixel = py * v.width + px;
  uint64_t there = visible[pixel];
  if (uint(there >> 32) < nearest) return;
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
  uint64_t mine = (uint64_t(float_bits(depth)) << 32) | uint64_t(sphere);
  if (mine < there) atomicMin(visible[pixel], mine);
}
#endif  // GLSL only: ends the choice above

void cut_into_tiles(uint sphere, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) tile[first + k] = uvec2(sphere, k);
}

// SLOT_SEEN_LIST, and the four bits that say for how many frames a sphere remains in it.
uint first_seen(uint turn) { return turn * (p.n + 1u); }
uint shift_in_word(uint seen) { return 4u * (seen % 8u); }
uint left_of(uint seen) { return seen_left[seen / 8u] >> shift_in_word(seen) & 15u; }

// The pixels that a sphere may cover: an empty box if it is culled or left to draw_tiles.
struct Footprint {
  vec4 seen;
  Box box;
  uint nearest, sphere;
};

// Returns the footprint of a sphere. It is skipped if it is outside the frustum, between pixel centres, hidden or drawn
// before, and cut into tiles if it is large. One of its threads, which `leads`, does that and copies its contacts from
// cell order.
Footprint footprint_of(uint k, bool leads) {
  vec4 found = position[k];
  vec4 seen = in_camera(with_radius(found), v);
  Footprint footprint = {seen, {0u, 0u, 0u, 0u}, 0u, 0u};
  Box box = footprint.box;
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  if (none && leads) count_drawn(seen.w == 0.0f ? DRAWN_UNDRAWABLE : DRAWN_UNSEEN);
  if (none) return footprint;
  bool rest = v.occlusion != 0u && v.phase != PHASE_SEEN;
  footprint.nearest = least_depth_of(seen, box, v);
  bool testable = rest && box.width * box.height > PIXELS_UNTESTED;
  bool hidden = testable && is_hidden(box, footprint.nearest, level_for(box));
  if (hidden) count_drawn(DRAWN_HIDDEN);
  if (hidden) return footprint;
  footprint.sphere = sphere_index(found, k);
  bool unsorts = index_source() != 0u && v.colour_by == COLOUR_BY_CONTACTS;
  if (leads && unsorts) count[footprint.sphere] = sorted_count[k];
  if (rest && left_of(footprint.sphere) != 0u) return footprint;
  bool large = is_large(box, v);
  if (leads) count_drawn(large ? DRAWN_LARGE : DRAWN_SMALL);
  if (!large) footprint.box = box;
  if (large && leads) cut_into_tiles(footprint.sphere, box);
  return footprint;
}

// Draws one thread's share of a footprint.
void draw_footprint(Footprint footprint, uint lane, uint lanes, uint across) {
  Box box = footprint.box;
  for (uint y = box.y + lane / across; y < box.y + box.height; y += lanes / across)
    for (uint x = box.x + lane % across; x < box.x + box.width; x += across)
      draw_at(x, y, footprint.seen, footprint.nearest, footprint.sphere);
}
