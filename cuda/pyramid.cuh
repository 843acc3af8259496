// SPDX-License-Identifier: MIT
// What the pyramid of depths says of a box.
#pragma once

#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

// Whether something nearer than `nearest` is seen already at every pixel of the box, as far as this level tells.
__device__ inline bool is_hidden(const World& w, const View& v, Box box, uint nearest, uint level) {
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return false;
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (w.pyramid[first + y * width + x] >= nearest) return false;
  return true;
}

}  // namespace spherepair
