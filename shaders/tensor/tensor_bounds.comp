#version 450
// SPDX-License-Identifier: MIT
// TENSOR_BOUNDS_GROUPS groups share the spheres: each writes the box of its finite centres, with its greatest radius.
#include "shaders/tensor/box.glsl"
#include "common/shared/tensor_form.h"

layout(std430, binding = SLOT_SCAN) restrict writeonly buffer BoxBuffer { vec4 boxes[]; };
layout(local_size_x = BLOCK) in;
const float GREATEST = 3.402823466e38f;

void main() {
  uint lane = gl_LocalInvocationID.x;
  vec4 own_low = {GREATEST, GREATEST, GREATEST, 0.0f};
  vec4 own_high = {-GREATEST, -GREATEST, -GREATEST, 0.0f};
  for (uint i = gl_WorkGroupID.x * BLOCK + lane; i < p.n; i += gl_NumWorkGroups.x * BLOCK) {
    vec4 sphere = position[i];
    vec4 with_radius = {sphere.x, sphere.y, sphere.z, larger(sphere.w, -sphere.w)};
    if (finite_sphere(sphere)) widen(own_low, own_high, sphere, with_radius);
  }
  low[lane] = own_low;
  high[lane] = own_high;
  widen_first(BLOCK);  // GLSL only: of the boxes that box.glsl declares
  if (lane == 0u) boxes[gl_WorkGroupID.x] = low[0];
  if (lane == 1u) boxes[TENSOR_BOUNDS_GROUPS + gl_WorkGroupID.x] = high[0];
}
