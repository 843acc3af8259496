#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: tests it against all others, which pass through shared memory a tile at a time (the paper's
// code 5).
#include "shaders/collide/collide.glsl"

layout(local_size_x = BLOCK) in;
shared vec4 tile[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint i = group_index() * BLOCK + lane;
  vec4 mine = position[min(i, p.n - 1u)];
  start_totals();
  uint contacts = 0u;
  for (uint first = 0u; first < p.n; first += BLOCK) {
    tile[lane] = position[min(first + lane, p.n - 1u)];
    barrier();
    uint others = min(uint(BLOCK), p.n - first);
    for (uint k = 0u; k < others; ++k) {
      if (in_reach(mine, tile[k])) contacts += test_ordered_pair(i, mine, first + k, tile[k]);
    }
    barrier();
  }
  if (contacts != 0u) add_contact(i, contacts);
  finish_totals();
}
