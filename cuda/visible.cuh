// SPDX-License-Identifier: MIT
// The picture's buffers, and how a sphere is put at a pixel: of all that the pixel's ray meets, the least depth stays,
// and of equal ones the least number, whatever the order of the threads.
#pragma once

#include "draw.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline void count_drawn(const World& w, const View& v, uint word) {
  if (v.counting != 0u && v.pass == PASS_DEPTH) atomicAdd(&w.drawn[word], 1u);
}

__device__ inline void draw_at(const World& w, const View& v, uint px, uint py, vec4 seen, uint sphere) {
  float depth = depth_of_hit(seen, ray_through(px, py, v), v);
  if (depth == 0.0f) return;
  uint pixel = py * v.width + px;
  unsigned long long mine = (uint64_t(float_bits(depth)) << 32) | uint64_t(sphere);
  unsigned long long* visible = reinterpret_cast<unsigned long long*>(w.visible);
  if (mine < __ldcg(&visible[pixel])) atomicMin(&visible[pixel], mine);
}

}  // namespace spherepair
