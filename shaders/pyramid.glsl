// SPDX-License-Identifier: MIT
// What the pyramid of depths says of a box.
#include "buffers.glsl"
#include "cluster.h"

layout(std140, binding = SLOT_VIEW) uniform ViewBlock { View v; };
layout(std430, binding = SLOT_PYRAMID) restrict readonly buffer PyramidBuffer { uint pyramid[]; };

// Whether something nearer than `nearest` is seen already at every pixel of the box, as far as this level tells.
bool is_hidden(Box box, uint nearest, uint level) {
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return false;
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (pyramid[first + y * width + x] >= nearest) return false;
  return true;
}
