// SPDX-License-Identifier: MIT
// One group per tile of a large sphere; a fixed number of groups loops over the tiles, whose pixels its threads share.
#include "cuda/draw/visibility_buffer.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) draw_tiles(Params p, KernelBuffers buf, View v) {
  uint tiles = min(buf.drawn[DRAWN_TILES], v.tile_capacity);
  for (uint t = buf.drawn[DRAWN_TILES_DONE] + group_index(p); t < tiles; t += group_count()) {
    uint sphere = buf.tile[t].x;
    vec4 seen = in_camera(buf.position[sphere], v);
    Box box = box_of(seen, v);
    uint column = buf.tile[t].y % tiles_along(box.width);
    uint row = buf.tile[t].y / tiles_along(box.width);
    box = tile_of(box, column, row);
    uint nearest = least_depth_of(seen, box, v);
    if (v.occlusion != 0u && v.phase != PHASE_SEEN && is_hidden(buf, v, box, nearest, 1u)) continue;
    for (uint k = threadIdx.x; k < TILE * TILE; k += BLOCK) {
      uint x = k % TILE;
      uint y = k / TILE;
      if (x < box.width && y < box.height) draw_at(buf, v, box.x + x, box.y + y, seen, nearest, sphere);
    }
  }
}

Entry draw_tiles_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_tiles); }

}  // namespace spherepair
