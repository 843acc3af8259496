// SPDX-License-Identifier: MIT
// What the pyramid of depths says of a box.
#pragma once

#include "common/shared/cluster.h"
#include "cuda/kernels.cuh"

namespace spherepair {

// Whether something nearer than `nearest` is seen already at every pixel of the box, as far as this level tells.
__device__ inline bool is_hidden(const KernelBuffers& w, const View& v, Box box, uint nearest, uint level) {
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return false;
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (w.pyramid[first + y * width + x].x >= nearest) return false;
  return true;
}

// What the texels of a box say together; infinite when they are too many to look up. Those that are left are not asked
// for once something seen, or in phases that put nothing off anything, is no nearer than `nearest`.
__device__ inline uvec2 texel_of_box(const KernelBuffers& w, const View& v, Box box, uint nearest, uint level) {
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
      uvec2 a = w.pyramid[row + x];  // all four on their way before the first is asked
      uvec2 b = w.pyramid[row + min(x + 1u, right)];
      uvec2 c = w.pyramid[row + min(x + 2u, right)];
      uvec2 d = w.pyramid[row + min(x + 3u, right)];
      all = texel_of_both(texel_of_both(all, a), texel_of_both(b, texel_of_both(c, d)));
      if ((v.phase == uint(PHASE_NEAR) ? all.y : all.x) >= nearest) return all;
    }
  }
  return all;
}

}  // namespace spherepair
