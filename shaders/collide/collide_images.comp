#version 450
// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: decides whether the two spheres collide in a periodic box. Near
// pairs are those of contacts, in any order.
#include "shaders/collide/collide.glsl"
#include "common/shared/contact/image_pair.h"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_NEAR) restrict readonly buffer NearBuffer { uvec2 near[]; };

void main() {
  start_totals();
  for (uint k = group_index() * BLOCK + gl_LocalInvocationID.x; k < p.search.near_pairs; k += group_count() * BLOCK) {
    uint i = near[k].x;
    uint j = near[k].y;
    if (i == j) continue;  // none
    if (!images_collide(position[i], position[j], p.contact, p.search.filter_scale, p.search.filter_offset)) continue;
    record(i, j);
    add_contact(i, 1u);
    add_contact(j, 1u);
  }
  finish_totals();
}
