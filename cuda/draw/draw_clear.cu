// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: clears the visibility buffer and lists the spheres that were visible in it. Not
// needed if draw_resolve cleared the previous frame's pixels and there were as many.
#include "cuda/draw/visible_list.cuh"

namespace spherepair {

__global__ void __launch_bounds__(BLOCK) draw_clear(Params p, KernelBuffers buf, View v) {
  uint lane = threadIdx.x;
  if (group_index(p) == 0u && lane < DRAWN_WORDS && lane != DRAWN_SEEN + v.turn) buf.drawn[lane] = 0u;
  begin_list();
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index(p) * PIXELS_EACH + k) * BLOCK + lane;
    if (pixel < v.width * v.height) clear_pixel(buf, v, pixel);
  }
  end_list(p, buf, v.turn);
}

Entry draw_clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_clear); }

}  // namespace spherepair
