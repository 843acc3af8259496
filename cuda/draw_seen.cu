// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out the spheres that the last picture showed; one thread per sphere.
#include "batch.cuh"

namespace spherepair {

__global__ void __launch_bounds__(BATCH) draw_seen(Params p, World w, View v) {
  uint count = w.drawn[DRAWN_SEEN + v.turn];
  for (uint first = group_index(p) * BATCH; first < count; first += group_count() * BATCH) {
    uint k = first + threadIdx.x;
    draw_batch(p, w, v, k < count ? w.seen_list[k] : 0u, k < count);
  }
}

Entry draw_seen_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_seen); }

}  // namespace spherepair
