#version 450
// SPDX-License-Identifier: MIT
// One group per tile of a large sphere; a fixed number of groups loops over the tiles, whose pixels its threads share.
#include "shaders/draw/visibility_buffer.glsl"

layout(local_size_x = BLOCK) in;

void main() {
  uint tiles = min(drawn[DRAWN_TILES], v.tile_capacity);
  for (uint t = drawn[DRAWN_TILES_DONE] + group_index(); t < tiles; t += group_count()) {
    uint sphere = tile[t].x;
    vec4 seen = in_camera(position[sphere], v);
    Box box = box_of(seen, v);
    uint column = tile[t].y % tiles_along(box.width);
    uint row = tile[t].y / tiles_along(box.width);
    box = tile_of(box, column, row);
    uint nearest = least_depth_of(seen, box, v);
    if (v.occlusion != 0u && v.phase != PHASE_SEEN && is_hidden(box, nearest, 1u)) continue;
    for (uint k = gl_LocalInvocationID.x; k < TILE * TILE; k += BLOCK) {
      uint x = k % TILE;
      uint y = k / TILE;
      if (x < box.width && y < box.height) draw_at(box.x + x, box.y + y, seen, nearest, sphere);
    }
  }
}
