#version 450
// SPDX-License-Identifier: MIT
// A fixed number of groups shares out the tiles of large spheres; a group's threads share the pixels of its tile.
#include "visible.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint tiles = min(drawn[DRAWN_TILES], v.tile_capacity);
  for (uint t = drawn[DRAWN_TILES_DONE] + group_index(); t < tiles; t += group_count()) {
    uint place = tile[t].x;
    vec4 seen = in_camera(position[place], v);
    Box box = box_of(seen, v);
    uint nearest = least_depth_of(seen);
    uint sphere = p.in_cells != 0u ? id[place] : place;
    uint column = tile[t].y % tiles_along(box.width);
    uint row = tile[t].y / tiles_along(box.width);
    uint end_x = box.x + min(box.width, (column + 1u) * TILE);
    uint end_y = box.y + min(box.height, (row + 1u) * TILE);
    for (uint k = gl_LocalInvocationID.x; k < TILE * TILE; k += BLOCK) {
      uint x = box.x + column * TILE + k % TILE;
      uint y = box.y + row * TILE + k / TILE;
      if (x < end_x && y < end_y) draw_at(x, y, seen, nearest, sphere);
    }
  }
}
