// SPDX-License-Identifier: MIT
// A fixed number of groups shares out the tiles of large spheres; a group's threads share the pixels of its tile.
#include "visible.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_tiles(Params p, World w, View v) {
  uint tiles = min(w.drawn[DRAWN_TILES], v.tile_capacity);
  for (uint t = w.drawn[DRAWN_TILES_DONE] + group_index(p); t < tiles; t += group_count()) {
    uint place = w.tile[t].x;
    vec4 seen = in_camera(w.position[place], v);
    Box box = box_of(seen, v);
    uint nearest = least_depth_of(seen);
    uint sphere = p.in_cells != 0u ? w.id[place] : place;
    uint column = w.tile[t].y % tiles_along(box.width);
    uint row = w.tile[t].y / tiles_along(box.width);
    uint end_x = box.x + min(box.width, (column + 1u) * TILE);
    uint end_y = box.y + min(box.height, (row + 1u) * TILE);
    for (uint k = threadIdx.x; k < TILE * TILE; k += SERVICE_BLOCK) {
      uint x = box.x + column * TILE + k % TILE;
      uint y = box.y + row * TILE + k / TILE;
      if (x < end_x && y < end_y) draw_at(w, v, x, y, seen, nearest, sphere);
    }
  }
}

Entry draw_tiles_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_tiles); }

}  // namespace spherepair
