#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere adds to the count of a scattered other one: measures the rate of atomics without a result.
#include "shaders/kernels.glsl"
#include "common/shared/peak_rate.h"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= p.n) return;
  atomicAdd(count[scattered(i, p.n)], 1u);
}
