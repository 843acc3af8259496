// SPDX-License-Identifier: MIT
// One thread per sphere: it is passed over when it is out of view or between the pixels' centres, tried at every pixel
// of its box when that is small, and cut into tiles for draw_tiles when it is large.
#include "visible.cuh"

namespace spherepair {

__device__ inline void cut_into_tiles(const World& w, const View& v, uint place, Box box) {
  uint tiles = tiles_along(box.width) * tiles_along(box.height);
  uint first = atomicAdd(&w.drawn[DRAWN_TILES], tiles);
  for (uint k = 0u; k < tiles && first + k < v.tile_capacity; ++k) w.tile[first + k] = uvec2{place, k};
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_spheres(Params p, World w, View v) {
  uint place = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (place >= p.n) return;
  vec4 seen = in_camera(w.position[place], v);
  Box box = {0u, 0u, 0u, 0u};
  if (in_frustum(seen, v)) box = box_of(seen, v);
  bool none = box.width == 0u || box.height == 0u;
  bool large = !none && (box.width > WALK_AT_MOST || box.height > WALK_AT_MOST);
  count_drawn(w, v, seen.w == 0.0f ? DRAWN_UNDRAWABLE : none ? DRAWN_UNSEEN : large ? DRAWN_LARGE : DRAWN_SMALL);
  if (none) return;
  if (large) {
    cut_into_tiles(w, v, place, box);
    return;
  }
  uint sphere = p.in_cells != 0u ? w.id[place] : place;
  for (uint y = box.y; y < box.y + box.height; ++y)
    for (uint x = box.x; x < box.x + box.width; ++x) draw_at(w, v, x, y, seen, sphere);
}

Entry draw_spheres_kernel() { return reinterpret_cast<Entry>(&draw_spheres); }

}  // namespace spherepair
