// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: no sphere is seen there yet. Those that the last picture showed are listed. Done
// by draw_resolve of the picture before, unless that kept its pixels or had fewer.
#include "cuda/draw/shown.cuh"

namespace spherepair {

__global__ void __launch_bounds__(PIXELS_BLOCK) draw_clear(Params p, KernelBuffers w, View v) {
  uint lane = threadIdx.x;
  if (group_index(p) == 0u && lane < DRAWN_WORDS && lane != DRAWN_SEEN + v.turn) w.drawn[lane] = 0u;
  Shown shown = begin_list();
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index(p) * PIXELS_EACH + k) * PIXELS_BLOCK + lane;
    if (pixel < v.width * v.height) clear_pixel(w, v, shown, pixel);
  }
  end_list(p, w, shown, v.turn);
}

Entry draw_clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_clear); }

}  // namespace spherepair
