#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: it is tested against all others, which pass through shared memory a tile at a time, for
// contact at any time within the next step.
#include "shaders/collide/collide.glsl"
#include "common/shared/swept.h"

layout(local_size_x = BLOCK) in;
shared vec4 tile[BLOCK];
shared vec4 tile_velocity[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint i = group_index() * BLOCK + lane;
  vec4 mine = position[min(i, p.n - 1u)];
  vec4 my_velocity = velocity[min(i, p.n - 1u)];
  start_totals();
  uint contacts = 0u;
  for (uint first = 0u; first < p.n; first += BLOCK) {
    tile[lane] = position[min(first + lane, p.n - 1u)];
    tile_velocity[lane] = velocity[min(first + lane, p.n - 1u)];
    barrier();
    uint others = min(uint(BLOCK), p.n - first);
    for (uint k = 0u; k < others; ++k) {
      uint j = first + k;
      if (i >= p.n || i == j) continue;
      if (!in_swept_reach(mine, my_velocity, tile[k], tile_velocity[k], p.motion.dt)) continue;
      if (!touch_within(mine, my_velocity, tile[k], tile_velocity[k], p.motion.dt, p.search.filter_scale,
                        p.search.filter_offset))
        continue;
      contacts += 1u;
      if (i < j) record(i, j);
    }
    barrier();
  }
  if (contacts != 0u) add_contact(i, contacts);
  finish_totals();
}
