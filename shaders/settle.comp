#version 450
// SPDX-License-Identifier: MIT
// A fixed number of threads shares out the deferred pairs: each is decided exactly, and recorded if it collides.
#include "collide.glsl"
#include "exact.h"

layout(local_size_x = BLOCK) in;

void main() {
  if (summary[SUM_DEFERRED] == 0u) return;
  start_totals();
  uint pairs = min(summary[SUM_DEFERRED], p.deferred_capacity);
  uint row = (group_index() % SUMMARY_SLOTS) * SUMMARY_WORDS;
  for (uint k = group_index() * BLOCK + gl_LocalInvocationID.x; k < pairs; k += BLOCK * gl_NumWorkGroups.x) {
    uvec2 pair = deferred[k];
    Verdict verdict = decide_exact(position[pair.x], position[pair.y]);
    atomicAdd(summary[row + SUM_STAGE + verdict.stage], 1u);
    if (verdict.collide) {
      record(sphere_at(pair.x), sphere_at(pair.y));
      touch(pair.x, 1u);
      touch(pair.y, 1u);
    }
  }
  finish_totals();
}
