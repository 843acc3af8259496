// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out the spheres that the last pictures showed; one thread per
// sphere.
#include "listing.cuh"

namespace spherepair {

// Whether it stays in the list; what is not seen again fades.
__device__ inline bool stays(const World& w, const View& v, uint seen) {
  uint left = left_of(w, seen);
  uint fades = min(left, v.occlusion == 1u ? SEEN_FADES : TOGETHER_FADES);
  atomicAdd(&w.seen_left[seen / 8u], 0u - (fades << shift_in_word(seen)));
  return left > fades;
}

__global__ void __launch_bounds__(BATCH) draw_seen(Params p, World w, View v) {
  uint total = w.drawn[DRAWN_SEEN + v.turn] * v.occlusion;
  uint next = 1u - v.turn;
  uint lane = threadIdx.x % v.lanes;
  uint at_once = BATCH / v.lanes;
  for (uint first = group_index(p) * at_once; first < total; first += group_count() * at_once) {
    uint k = first + threadIdx.x / v.lanes;
    uint seen = k < total ? w.seen_list[first_seen(p, v, v.turn) + k / v.occlusion] : 0u;
    uint sphere = seen * v.occlusion + k % v.occlusion;
    bool leads = k < total && lane == 0u && k % v.occlusion == 0u;
    bool kept = leads && v.pass == PASS_DEPTH && stays(w, v, seen);
    uint place = place_in_list(w, DRAWN_SEEN + next, kept);
    if (kept) w.seen_list[first_seen(p, v, next) + place] = seen;
    if (k < total && sphere < p.n)
      draw_walk(w, v, walk_of(p, w, v, sphere, lane == 0u), lane, v.lanes, lanes_across(v));
  }
}

Entry draw_seen_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_seen); }

}  // namespace spherepair
