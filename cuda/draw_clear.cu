// SPDX-License-Identifier: MIT
// One thread per pixel: no sphere is seen yet. The list of clusters that the last picture showed is drawn next.
#include "visible.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_clear(Params p, World w, View v) {
  uint pixel = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (pixel < DRAWN_WORDS && pixel != DRAWN_SEEN + v.turn) w.drawn[pixel] = 0u;
  if (pixel >= v.width * v.height) return;
  w.visible[pixel] = uvec2{0xFFFFFFFFu, 0xFFFFFFFFu};
}

Entry draw_clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_clear); }

}  // namespace spherepair
