// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out the spheres that the last pictures showed; one thread per
// sphere.
#include "batch.cuh"
#include "listing.cuh"

namespace spherepair {

// Whether it stays in the list; what is not seen again fades.
__device__ inline bool stays(const World& w, uint sphere) {
  uint left = left_of(w, sphere);
  atomicAdd(&w.seen_left[sphere / 8u], 0u - (min(left, SEEN_FADES) << shift_in_word(sphere)));
  return left > SEEN_FADES;
}

__global__ void __launch_bounds__(BATCH) draw_seen(Params p, World w, View v) {
  uint count = w.drawn[DRAWN_SEEN + v.turn];
  uint next = 1u - v.turn;
  for (uint first = group_index(p) * BATCH; first < count; first += group_count() * BATCH) {
    uint k = first + threadIdx.x;
    uint sphere = k < count ? w.seen_list[v.turn * p.n + k] : 0u;
    bool kept = k < count && v.pass == PASS_DEPTH && stays(w, sphere);
    uint place = place_in_list(w, DRAWN_SEEN + next, kept);
    if (kept) w.seen_list[next * p.n + place] = sphere;
    draw_batch(p, w, v, sphere, k < count);
  }
}

Entry draw_seen_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_seen); }

}  // namespace spherepair
