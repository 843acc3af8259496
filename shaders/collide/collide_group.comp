#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: tests it against the spheres of its own group, in shared memory (the paper's code 4). Pairs
// across groups are not found.
#include "shaders/collide/collide.glsl"

layout(local_size_x = BLOCK) in;
shared vec4 tile[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * BLOCK;
  uint i = first + lane;
  vec4 mine = position[min(i, p.n - 1u)];
  tile[lane] = mine;
  start_totals();
  uint contacts = 0u;
  uint others = first < p.n ? min(uint(BLOCK), p.n - first) : 0u;
  for (uint k = 0u; k < others; ++k) {
    if (in_reach(mine, tile[k])) contacts += test_ordered_pair(i, mine, first + k, tile[k]);
  }
  if (contacts != 0u) add_contact(i, contacts);
  finish_totals();
}
