// SPDX-License-Identifier: MIT
// Joins the boxes of parts into the box of all centres, with the greatest radius in high.w.
#include "shaders/kernels.glsl"

// GLSL only from here: functions cannot take shared memory by reference, so the boxes are declared here
shared vec4 low[BLOCK], high[BLOCK];

void widen(inout vec4 own_low, inout vec4 own_high, vec4 other_low, vec4 other_high) {
  own_low =
      vec4(smaller(other_low.x, own_low.x), smaller(other_low.y, own_low.y), smaller(other_low.z, own_low.z), 0.0f);
  own_high = vec4(larger(other_high.x, own_high.x), larger(other_high.y, own_high.y), larger(other_high.z, own_high.z),
                  larger(other_high.w, own_high.w));
}

// Reduces the first `boxes` boxes, a power of two, to low[0] and high[0]. Every thread of the group calls it.
void widen_first(uint boxes) {
  for (uint left = boxes / 2u; left > 0u; left /= 2u) {
    barrier();
    uint k = gl_LocalInvocationID.x;
    if (k < left) widen(low[k], high[k], low[k + left], high[k + left]);
  }
  barrier();
}
// until here
