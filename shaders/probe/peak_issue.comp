#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere runs independent chains of multiply-adds in registers: measures the issue rate.
#include "shaders/kernels.glsl"
#include "common/shared/peak_rate.h"

layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= p.n) return;
  vec4 start = position[i];
  float chain[PEAK_CHAINS];
  for (uint k = 0u; k < PEAK_CHAINS; ++k) chain[k] = k % 2u == 0u ? start.x : start.y;
  for (uint turn = 0u; turn < PEAK_TURNS; ++turn) {
    for (uint step = 0u; step < PEAK_STEPS; ++step) {
      for (uint k = 0u; k < PEAK_CHAINS; ++k) chain[k] = towards_one(chain[k]);
    }
  }
  float least = chain[0];
  float most = chain[0];
  for (uint k = 1u; k < PEAK_CHAINS; ++k) {
    least = smaller(least, chain[k]);
    most = larger(most, chain[k]);
  }
  velocity[i] = vec4(least, most, chain[0], chain[1]);
}
