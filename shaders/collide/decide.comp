#version 450
// SPDX-License-Identifier: MIT
// One thread per pair of spheres: runs all stages of the predicate; reports the verdict and the stage that decided.
#include "shaders/kernels.glsl"
#include "common/shared/exact.h"

layout(std430, binding = SLOT_SPHERES) restrict readonly buffer SpheresBuffer { vec4 spheres[]; };
layout(std430, binding = SLOT_VERDICT) restrict writeonly buffer VerdictBuffer { uint verdict[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (k >= p.n) return;
  verdict[k] =
      verdict_code(decide_pair(spheres[2u * k], spheres[2u * k + 1u], p.search.filter_scale, p.search.filter_offset));
}
