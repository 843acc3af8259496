// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: the light on the sphere that is seen there, or the background.
#include "draw.h"
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_resolve(Params p, World w, View v) {
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index(p) * PIXELS_EACH + k) * SERVICE_BLOCK + threadIdx.x;
    if (pixel >= v.width * v.height) return;
    uvec2 seen = w.visible[pixel];
    uint colour = lit(v.background, 1.0f);
    if (seen.y != 0xFFFFFFFFu) {
      Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
      colour = shade(in_camera(w.position[seen.x], v), ray, bits_float(seen.y), w.count[seen.x], v);
    }
    w.image[pixel] = colour;
  }
}

Entry draw_resolve_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_resolve); }

}  // namespace spherepair
