// SPDX-License-Identifier: MIT
// A fixed number of groups shares out the spheres that the last pictures showed; one thread per sphere.
#define VISIBLE_LOAD __ldca  // what was seen long ago hides as well
#include "cuda/draw/batch.cuh"
#include "cuda/draw/listing.cuh"

namespace spherepair {

// Whether it stays in the list; what is not seen again fades.
__device__ inline bool stays(const KernelBuffers& w, uint sphere) {
  uint left = left_of(w, sphere);
  uint fades = min(left, SEEN_FADES);
  atomicAdd(&w.seen_left[sphere / 8u], 0u - (fades << shift_in_word(sphere)));
  return left > fades;
}

__global__ void __launch_bounds__(SEEN_BLOCK) draw_previously_visible(Params p, KernelBuffers w, View v) {
  uint total = w.drawn[DRAWN_SEEN + v.turn];
  uint next = 1u - v.turn;
  uint at_once = min(uint(SEEN_BLOCK), total / group_count() + 1u);  // no group is left without while others have many
  for (uint first = group_index(p) * at_once; first < total; first += group_count() * at_once) {
    uint k = first + threadIdx.x;
    bool exists = threadIdx.x < at_once && k < total;
    uint sphere = exists ? w.seen_list[first_seen(p, v.turn) + k] : 0u;
    bool kept = exists && v.pass == PASS_DEPTH && stays(w, sphere);
    uint sorted_index = index_in_list(w, DRAWN_SEEN + next, kept);
    if (kept) w.seen_list[first_seen(p, next) + sorted_index] = sphere;
    draw_batch<SEEN_BLOCK>(p, w, v, sphere, exists);
  }
}

Entry draw_previously_visible_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_previously_visible); }

}  // namespace spherepair
