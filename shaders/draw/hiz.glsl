// SPDX-License-Identifier: MIT
// Looks up the hierarchical Z, whose texels hold the greatest depth of their pixels.
#include "shaders/draw/view.glsl"
#include "shaders/kernels.glsl"
#include "common/shared/cluster.h"

// GLSL only from here: faster through a texture buffer
#ifdef TEXTURE_TABLE
layout(binding = PYRAMID_TEXTURE) uniform usamplerBuffer pyramid_texture;
uvec2 texel_at(uint k) { return texelFetch(pyramid_texture, int(k)).xy; }
#else
// until here
layout(std430, binding = SLOT_PYRAMID) restrict readonly buffer PyramidBuffer { uvec2 pyramid[]; };
uvec2 texel_at(uint k) { return pyramid[k]; }
#endif  // GLSL only: ends the choice above

// Whether every pixel of the box already shows something nearer than `nearest`, as far as this level can tell.
bool is_hidden(Box box, uint nearest, uint level) {
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return false;
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (texel_at(first + y * width + x).x >= nearest) return false;
  return true;
}

// Returns the maximum over the texels of a box; infinite if there are too many. It stops loading texels once the depth
// that decides in this phase is no nearer than `nearest`.
uvec2 texel_of_box(Box box, uint nearest, uint level) {
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
      uvec2 a = texel_at(row + x);  // all four loads are issued before the first is used
      uvec2 b = texel_at(row + min(x + 1u, right));
      uvec2 c = texel_at(row + min(x + 2u, right));
      uvec2 d = texel_at(row + min(x + 3u, right));
      all = texel_of_both(texel_of_both(all, a), texel_of_both(b, texel_of_both(c, d)));
      if ((v.phase == uint(PHASE_NEAR) ? all.y : all.x) >= nearest) return all;
    }
  }
  return all;
}
