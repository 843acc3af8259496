// SPDX-License-Identifier: MIT
// Clears pixels for the next frame, PIXELS_EACH a thread, and lists the spheres that were visible in them.
#pragma once

#include "cuda/draw/visibility_buffer.cuh"

namespace spherepair {

constexpr uint BLOCK = PIXELS_BLOCK;
__shared__ uint found[BLOCK * PIXELS_EACH];
__shared__ uint entries;  // of the group
__shared__ uint first_entry;

// CUDA only from here: the visibility buffer as pairs of words
__device__ inline uvec2 seen_at(const KernelBuffers& buf, uint pixel) { return buf.visible[pixel]; }
__device__ inline void clear_at(const KernelBuffers& buf, uint pixel) {
  buf.visible[pixel] = uvec2{0xFFFFFFFFu, 0xFFFFFFFFu};
}
// until here

// Whether the pixel's sphere is to be listed. Only pixels whose left and upper neighbours show another sphere, or are
// cleared already, test the bits of the sphere.
__device__ inline bool is_new(const KernelBuffers& buf, const View& v, uint pixel) {
  uint sphere = seen_at(buf, pixel).x;
  uint left = seen_at(buf, max(pixel, 1u) - 1u).x;
  uint above = seen_at(buf, max(pixel, v.width) - v.width).x;
  if (sphere == 0xFFFFFFFFu || (pixel >= 1u && left == sphere)) return false;
  if (pixel >= v.width && above == sphere) return false;
  uint all = 15u << shift_in_word(sphere);
  return (atomicOr(&buf.seen_left[sphere / 8u], all) & all) == 0u;
}

// All threads of the group must call begin_list before and end_list after their pixels. View::turn chooses the list.
__device__ inline void begin_list() {
  if (threadIdx.x == 0u) entries = 0u;
  __syncthreads();
}
__device__ inline void clear_pixel(const KernelBuffers& buf, const View& v, uint pixel) {
  if (v.occlusion != 0u && is_new(buf, v, pixel)) found[atomicAdd(&entries, 1u)] = seen_at(buf, pixel).x;
  clear_at(buf, pixel);
}
__device__ inline void end_list(const Params& p, const KernelBuffers& buf, uint turn) {
  uint lane = threadIdx.x;
  __syncthreads();
  if (lane == 0u && entries > 0u) first_entry = atomicAdd(&buf.drawn[DRAWN_SEEN + turn], entries);
  __syncthreads();
  if (entries == 0u) return;
  uint first = first_seen(p, turn) + first_entry;
  for (uint k = lane; k < entries; k += BLOCK) buf.seen_list[first + k] = found[k];
}

}  // namespace spherepair
