// SPDX-License-Identifier: MIT
// Pixels are cleared for the next picture, PIXELS_EACH a thread, and the spheres that they showed are listed for it.
#pragma once

#include "cuda/draw/visible.cuh"

namespace spherepair {

// Of the group: `found` has room for PIXELS_BLOCK * PIXELS_EACH spheres.
struct Shown {
  uint *found, *entries, *first_entry;
};

// Only the first of a sphere's pixels need to ask: one whose neighbours, unless they are cleared already, show another.
__device__ inline bool is_new(const KernelBuffers& w, const View& v, uint pixel) {
  uint sphere = w.visible[pixel].x;
  uint left = w.visible[max(pixel, 1u) - 1u].x;
  uint above = w.visible[max(pixel, v.width) - v.width].x;
  if (sphere == 0xFFFFFFFFu || (pixel >= 1u && left == sphere)) return false;
  if (pixel >= v.width && above == sphere) return false;
  uint all = 15u << shift_in_word(sphere);
  return (atomicOr(&w.seen_left[sphere / 8u], all) & all) == 0u;
}

// All threads of the group call it before and after their pixels; the list is that of a View::turn.
__device__ inline Shown begin_list() {
  __shared__ uint found[PIXELS_BLOCK * PIXELS_EACH];
  __shared__ uint entries, first_entry;
  if (threadIdx.x == 0u) entries = 0u;
  __syncthreads();
  return {found, &entries, &first_entry};
}
__device__ inline void clear_pixel(const KernelBuffers& w, const View& v, const Shown& shown, uint pixel) {
  if (v.occlusion != 0u && is_new(w, v, pixel)) shown.found[atomicAdd(shown.entries, 1u)] = w.visible[pixel].x;
  w.visible[pixel] = uvec2{0xFFFFFFFFu, 0xFFFFFFFFu};
}
__device__ inline void end_list(const Params& p, const KernelBuffers& w, const Shown& shown, uint turn) {
  uint lane = threadIdx.x;
  __syncthreads();
  uint entries = *shown.entries;
  if (lane == 0u && entries > 0u) *shown.first_entry = atomicAdd(&w.drawn[DRAWN_SEEN + turn], entries);
  __syncthreads();
  if (entries == 0u) return;
  uint first = first_seen(p, turn) + *shown.first_entry;
  for (uint k = lane; k < entries; k += PIXELS_BLOCK) w.seen_list[first + k] = shown.found[k];
}

}  // namespace spherepair
