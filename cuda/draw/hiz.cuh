// SPDX-License-Identifier: MIT
// Looks up the hierarchical Z, whose texels hold the greatest depth of their pixels.
#pragma once

#include "common/shared/cluster.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__device__ inline uvec2 texel_at(const KernelBuffers& buf, uint k) { return buf.pyramid[k]; }

// Whether every pixel of the box already shows something nearer than `nearest`, as far as this level can tell.
__device__ inline bool is_hidden(const KernelBuffers& buf, const View& v, Box box, uint nearest, uint level) {
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return false;
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (texel_at(buf, first + y * width + x).x >= nearest) return false;
  return true;
}

// Returns the maximum over the texels of a box; infinite if there are too many. It stops loading texels once the depth
// that decides in this phase is no nearer than `nearest`.
__device__ inline uvec2 texel_of_box(const KernelBuffers& buf, const View& v, Box box, uint nearest, uint level) {
  uvec2 all = {0xFFFFFFFFu, 0xFFFFFFFFu};
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return all;
  all = texel_of_pixel(0u);
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  uint right = (box.x + box.width - 1u) >> shift;
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y) {
    uint row = first + y * width;
    for (uint x = box.x >> shift; x <= right; x += 4u) {
      uvec2 a = texel_at(buf, row + x);  // all four loads are issued before the first is used
      uvec2 b = texel_at(buf, row + min(x + 1u, right));
      uvec2 c = texel_at(buf, row + min(x + 2u, right));
      uvec2 d = texel_at(buf, row + min(x + 3u, right));
      all = texel_of_both(texel_of_both(all, a), texel_of_both(b, texel_of_both(c, d)));
      if ((v.phase == uint(PHASE_NEAR) ? all.y : all.x) >= nearest) return all;
    }
  }
  return all;
}

}  // namespace spherepair
