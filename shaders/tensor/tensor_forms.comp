#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere writes its form. Threads past the last sphere fill its block of rows with forms that are near
// no other.
#include "shaders/tensor/box.glsl"
#include "common/shared/tensor_form.h"

layout(std430, binding = SLOT_SCAN) restrict readonly buffer BoxBuffer { vec4 boxes[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer FormBuffer { uvec4 forms[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint lane = gl_LocalInvocationID.x;
  // GLSL only from here: the low corners that tensor_bounds wrote, then the high ones
  uint own = min(lane, uint(TENSOR_BOUNDS_GROUPS - 1));
  low[lane] = boxes[own];
  high[lane] = boxes[TENSOR_BOUNDS_GROUPS + own];
  widen_first(TENSOR_BOUNDS_GROUPS);
  vec4 frame = tensor_frame(low[0], high[0]);
  // until here
  uint i = group_index() * BLOCK + lane;
  if (i >= (p.n + TENSOR_ROWS - 1u) / TENSOR_ROWS * TENSOR_ROWS) return;
  TensorForm form = i < p.n ? tensor_form(position[i], frame) : never_near_form();
  // GLSL only from here: sphere after sphere, so that a cooperative matrix can be loaded
  forms[2u * i] = form.low;
  forms[2u * i + 1u] = form.high;
  // until here
}
