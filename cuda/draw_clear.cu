// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: no sphere is seen there yet. Those that the last picture showed are listed.
#include "visible.cuh"

namespace spherepair {

// Only the first of a sphere's pixels need to ask: one whose neighbours, unless they are cleared already, show another.
__device__ inline bool is_new(const World& w, const View& v, uint pixel) {
  uint sphere = w.visible[pixel].x;
  uint left = w.visible[max(pixel, 1u) - 1u].x;
  uint above = w.visible[max(pixel, v.width) - v.width].x;
  if (sphere == 0xFFFFFFFFu || (pixel >= 1u && left == sphere)) return false;
  if (pixel >= v.width && above == sphere) return false;
  uint all = 15u << shift_in_word(sphere);
  return (atomicOr(&w.seen_left[sphere / 8u], all) & all) == 0u;
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_clear(Params p, World w, View v) {
  __shared__ uint found[SERVICE_BLOCK * PIXELS_EACH];
  __shared__ uint entries;  // of the group
  __shared__ uint first_entry;
  uint lane = threadIdx.x;
  if (group_index(p) == 0u && lane < DRAWN_WORDS && lane != DRAWN_SEEN + v.turn) w.drawn[lane] = 0u;
  if (lane == 0u) entries = 0u;
  __syncthreads();
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index(p) * PIXELS_EACH + k) * SERVICE_BLOCK + lane;
    if (pixel >= v.width * v.height) break;
    if (v.occlusion != 0u && is_new(w, v, pixel)) {
      found[atomicAdd(&entries, 1u)] = w.visible[pixel].x;
    }
    w.visible[pixel] = uvec2{0xFFFFFFFFu, 0xFFFFFFFFu};
  }
  __syncthreads();
  if (lane == 0u && entries > 0u) first_entry = atomicAdd(&w.drawn[DRAWN_SEEN + v.turn], entries);
  __syncthreads();
  if (entries == 0u) return;
  uint first = first_seen(p, v.turn) + first_entry;
  for (uint k = lane; k < entries; k += SERVICE_BLOCK) w.seen_list[first + k] = found[k];
}

Entry draw_clear_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_clear); }

}  // namespace spherepair
