#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere and group of other spheres: tests the sphere against that group in a single loop (the paper's
// two-dimensional arrangement).
#include "shaders/collide/collide.glsl"

layout(local_size_x = BLOCK) in;
shared vec4 tile[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint groups = (p.n + BLOCK - 1u) / BLOCK;
  uint mine_group = p.first_group + gl_WorkGroupID.x;
  uint other_group = gl_WorkGroupID.y + MAX_GROUPS * gl_WorkGroupID.z;
  if (mine_group >= groups || other_group >= groups) return;
  uint i = mine_group * BLOCK + lane;
  uint first = other_group * BLOCK;
  vec4 mine = position[min(i, p.n - 1u)];
  tile[lane] = position[min(first + lane, p.n - 1u)];
  start_totals();
  uint contacts = 0u;
  uint others = min(uint(BLOCK), p.n - first);
  for (uint k = 0u; k < others; ++k) {
    if (in_reach(mine, tile[k])) contacts += test_ordered_pair(i, mine, first + k, tile[k]);
  }
  if (contacts != 0u) add_contact(i, contacts);
  finish_totals();
}
