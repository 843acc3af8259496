// SPDX-License-Identifier: MIT
// A fixed number of groups shares out the tiles of large spheres; a group's threads share the pixels of its tile.
#include "cuda/draw/visible.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_tiles(Params p, KernelBuffers w, View v) {
  uint tiles = min(w.drawn[DRAWN_TILES], v.tile_capacity);
  for (uint t = w.drawn[DRAWN_TILES_DONE] + group_index(p); t < tiles; t += group_count()) {
    uint sphere = w.tile[t].x;
    vec4 seen = in_camera(w.position[sphere], v);
    Box box = box_of(seen, v);
    uint column = w.tile[t].y % tiles_along(box.width);
    uint row = w.tile[t].y / tiles_along(box.width);
    box = tile_of(box, column, row);
    uint nearest = least_depth_of(seen, box, v);
    if (v.occlusion != 0u && v.phase != PHASE_SEEN && is_hidden(w, v, box, nearest, 1u)) continue;
    for (uint k = threadIdx.x; k < TILE * TILE; k += SERVICE_BLOCK) {
      uint x = k % TILE;
      uint y = k / TILE;
      if (x < box.width && y < box.height) draw_at(w, v, box.x + x, box.y + y, seen, nearest, sphere);
    }
  }
}

Entry draw_tiles_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_tiles); }

}  // namespace spherepair
