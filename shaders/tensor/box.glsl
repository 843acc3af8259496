// SPDX-License-Identifier: MIT
// The box of all centres, with the greatest radius in high.w, from the boxes of parts.
#include "shaders/kernels.glsl"

// GLSL only from here: `inout` in place of references, and boxes that both kernels name, since shared memory has no
// addresses
shared vec4 low[BLOCK], high[BLOCK];

void widen(inout vec4 own_low, inout vec4 own_high, vec4 other_low, vec4 other_high) {
  own_low =
      vec4(smaller(other_low.x, own_low.x), smaller(other_low.y, own_low.y), smaller(other_low.z, own_low.z), 0.0f);
  own_high = vec4(larger(other_high.x, own_high.x), larger(other_high.y, own_high.y), larger(other_high.z, own_high.z),
                  larger(other_high.w, own_high.w));
}

// Of so many boxes, a power of two: the first becomes that of all. For all threads of a group.
void widen_first(uint boxes) {
  for (uint left = boxes / 2u; left > 0u; left /= 2u) {
    barrier();
    uint k = gl_LocalInvocationID.x;
    if (k < left) widen(low[k], high[k], low[k + left], high[k + left]);
  }
  barrier();
}
// until here
