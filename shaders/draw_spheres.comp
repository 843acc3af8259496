#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: it is passed over when it is out of view or between the pixels' centres, tried at every pixel
// of its box when that is small, and cut into tiles for draw_tiles when it is large.
#include "visible.glsl"

layout(local_size_x = BLOCK) in;

void cut_into_tiles(uint place, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) tile[first + k] = uvec2(place, k);
}

void main() {
  uint place = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (place >= p.n) return;
  vec4 seen = in_camera(position[place], v);
  Box box = Box(0u, 0u, 0u, 0u);
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  bool large = !none && (box.width > WALK_AT_MOST || box.height > WALK_AT_MOST);
  count_drawn(seen.w == 0.0f ? DRAWN_UNDRAWABLE : none ? DRAWN_UNSEEN : large ? DRAWN_LARGE : DRAWN_SMALL);
  if (none) return;
  if (large) {
    cut_into_tiles(place, box);
    return;
  }
  uint sphere = p.in_cells != 0u ? id[place] : place;
  for (uint y = box.y; y < box.y + box.height; ++y)
    for (uint x = box.x; x < box.x + box.width; ++x) draw_at(x, y, seen, sphere);
}
