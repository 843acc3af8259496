// SPDX-License-Identifier: MIT
// One thread per sphere; a fixed number of groups loops over the spheres visible in recent frames, and draws them.
#define VISIBLE_LOAD __ldca  // a stale depth only costs time
#include "cuda/draw/append.cuh"
#include "cuda/draw/batch.cuh"

namespace spherepair {

constexpr uint BLOCK = SEEN_BLOCK;

// Whether the sphere stays in the list; it leaves after some frames in which it is not visible.
__device__ inline bool stays(const KernelBuffers& buf, uint sphere) {
  uint left = left_of(buf, sphere);
  uint fades = min(left, SEEN_FADES);
  atomicAdd(&buf.seen_left[sphere / 8u], 0u - (fades << shift_in_word(sphere)));
  return left > fades;
}

__global__ void __launch_bounds__(BLOCK) draw_previously_visible(Params p, KernelBuffers buf, View v) {
  uint total = buf.drawn[DRAWN_SEEN + v.turn];
  uint next = 1u - v.turn;
  uint at_once = min(uint(BLOCK), total / group_count() + 1u);  // few spheres are spread over all groups
  for (uint first = group_index(p) * at_once; first < total; first += group_count() * at_once) {
    uint k = first + threadIdx.x;
    bool exists = threadIdx.x < at_once && k < total;
    uint sphere = exists ? buf.seen_list[first_seen(p, v.turn) + k] : 0u;
    bool kept = exists && v.pass == PASS_DEPTH && stays(buf, sphere);
    uint at = append_index(buf, DRAWN_SEEN + next, kept);
    if (kept) buf.seen_list[first_seen(p, next) + at] = sphere;
    draw_batch<BLOCK>(p, buf, v, sphere, exists);
  }
}

Entry draw_previously_visible_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_previously_visible); }

}  // namespace spherepair
