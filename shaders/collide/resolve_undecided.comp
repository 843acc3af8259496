#version 450
// SPDX-License-Identifier: MIT
// A fixed number of threads loops over the deferred pairs: each pair is decided exactly and recorded if it collides.
#include "shaders/collide/collide.glsl"
#include "common/shared/exact.h"

layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  uvec2 pair = deferred[min(
      k, p.search.deferred_capacity - 1u)];  // loaded before it is known to exist, to overlap the two latencies
  uint pairs = min(summary[SUM_DEFERRED], p.search.deferred_capacity);
  if (group_index() * BLOCK >= pairs) return;
  start_totals();
  uint row = (group_index() % SUMMARY_SLOTS) * SUMMARY_WORDS;
  for (; k < pairs; k += BLOCK * gl_NumWorkGroups.x) {
    vec4 a = position[pair.x];
    vec4 b = position[pair.y];
    Verdict verdict = decide_exact(with_radius(a), with_radius(b));
    atomicAdd(summary[row + SUM_STAGE + verdict.stage], 1u);
    if (verdict.collide) {
      record(sphere_index(a, pair.x), sphere_index(b, pair.y));
      add_contact(pair.x, 1u);
      add_contact(pair.y, 1u);
    }
    pair = deferred[min(k + BLOCK * gl_NumWorkGroups.x, p.search.deferred_capacity - 1u)];
  }
  finish_totals();
}
