// SPDX-License-Identifier: MIT
// The picture's buffers, and how a sphere is put at a pixel: of all that the pixel's ray meets, the least depth stays,
// and of equal ones the least number, whatever the order of the threads.
#include "shaders/draw/pyramid.glsl"

#ifndef VISIBLE_ACCESS
#define VISIBLE_ACCESS coherent
#endif

#ifdef ATOMICS_64
layout(std430, binding = SLOT_VISIBLE) restrict VISIBLE_ACCESS buffer VisibleBuffer { uint64_t visible[]; };
#else
layout(std430, binding = SLOT_VISIBLE) restrict VISIBLE_ACCESS buffer VisibleBuffer { uint visible[]; };
#endif
layout(std430, binding = SLOT_SORTED_COUNT) restrict readonly buffer SortedCountBuffer { uint sorted_count[]; };
layout(std430, binding = SLOT_TILE) restrict buffer TileBuffer { uvec2 tile[]; };
layout(std430, binding = SLOT_DRAWN) restrict buffer DrawnBuffer { uint drawn[]; };
layout(std430, binding = SLOT_SEEN_LEFT) restrict buffer SeenLeftBuffer { uint seen_left[]; };
layout(std430, binding = SLOT_SEEN_LIST) restrict buffer SeenListBuffer { uint seen_list[]; };

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

void cut_into_tiles(uint sphere, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) tile[first + k] = uvec2(sphere, k);
}

// The list of those seen and, in four bits, for how long each still stands there.
uint first_seen(uint turn) { return turn * (p.n + 1u); }
uint shift_in_word(uint seen) { return 4u * (seen % 8u); }
uint left_of(uint seen) { return seen_left[seen / 8u] >> shift_in_word(seen) & 15u; }

// Where a sphere is to be tried: an empty box where that is nowhere, or draw_tiles does it.
struct Walk {
  vec4 seen;
  Box box;
  uint nearest, sphere;
};

// It is passed over when it is out of view, between the pixels' centres, hidden or drawn before, and cut into tiles
// when it is large. One of its threads leads. The contacts of whatever may be seen come along from the cell order.
Walk walk_of(uint sorted_index, bool leads) {
  vec4 found = position[sorted_index];
  vec4 seen = in_camera(with_radius(found), v);
  Walk walk = {seen, {0u, 0u, 0u, 0u}, 0u, 0u};
  Box box = walk.box;
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  if (none && leads) count_drawn(seen.w == 0.0f ? DRAWN_UNDRAWABLE : DRAWN_UNSEEN);
  if (none) return walk;
  bool rest = v.occlusion != 0u && v.phase != PHASE_SEEN;
  walk.nearest = least_depth_of(seen, box, v);
  bool asks = rest && box.width * box.height > WALK_UNTESTED;
  bool hidden = asks && is_hidden(box, walk.nearest, level_for(box));
  if (hidden) count_drawn(DRAWN_HIDDEN);
  if (hidden) return walk;
  walk.sphere = sphere_index(found, sorted_index);
  if (leads && p.in_cells != 0u) count[walk.sphere] = sorted_count[sorted_index];
  if (rest && left_of(walk.sphere) != 0u) return walk;
  bool large = is_large(box, v);
  if (leads) count_drawn(large ? DRAWN_LARGE : DRAWN_SMALL);
  if (!large) walk.box = box;
  if (large && leads) cut_into_tiles(walk.sphere, box);
  return walk;
}

// The work of one of the threads that share the pixels of a walk.
void draw_walk(Walk walk, uint lane, uint lanes, uint across) {
  Box box = walk.box;
  for (uint y = box.y + lane / across; y < box.y + box.height; y += lanes / across)
    for (uint x = box.x + lane % across; x < box.x + box.width; x += across)
      draw_at(x, y, walk.seen, walk.nearest, walk.sphere);
}
