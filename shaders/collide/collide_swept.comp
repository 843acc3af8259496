#version 450
// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: decides whether the two spheres touch at any time within the
// next step. Near pairs are the colliding pairs of spheres around the paths in the step, in any order. SLOT_GROWN holds
// the velocities with which the paths begin.
#include "shaders/collide/collide.glsl"
#include "common/shared/swept.h"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_NEAR) restrict readonly buffer NearBuffer { uvec2 near[]; };
layout(std430, binding = SLOT_GROWN) restrict readonly buffer GrownBuffer { vec4 grown[]; };

void main() {
  start_totals();
  for (uint k = group_index() * BLOCK + gl_LocalInvocationID.x; k < p.search.near_pairs; k += group_count() * BLOCK) {
    uint i = near[k].x;
    uint j = near[k].y;
    bool touch = touch_within(position[i], grown[i], position[j], grown[j], p.motion, p.search.filter_scale,
                              p.search.filter_offset);
    if (!touch) continue;
    record(i, j);
    add_contact(i, 1u);
    add_contact(j, 1u);
  }
  finish_totals();
}
