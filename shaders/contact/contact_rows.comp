#version 450
// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: adds each of the two spheres to the other's row, in any order.
// If rows are too short, the longest length is recorded, and all rows are filled again.
#include "shaders/kernels.glsl"
#include "common/shared/contact/skin.h"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_FAULT) restrict buffer FaultBuffer { uint fault[]; };
layout(std430, binding = SLOT_NEAR) restrict readonly buffer NearBuffer { uvec2 near[]; };
layout(std430, binding = SLOT_ROW) restrict buffer RowBuffer { uint row[]; };
layout(std430, binding = SLOT_ROW_LENGTH) restrict buffer RowLengthBuffer { uint row_length[]; };

void join_row(uint i, uint j) {
  uint k = atomicAdd(row_length[i], 1u);
  if (k < p.contact.row_capacity) {
    row[k * p.n + i] = j;
  } else {
    atomicMax(fault[LONGEST_ROW], k + 1u);
  }
}

void main() {
  uint pairs = p.search.near_pairs;
  for (uint k = group_index() * BLOCK + gl_LocalInvocationID.x; k < pairs; k += group_count() * BLOCK) {
    join_row(near[k].x, near[k].y);
    join_row(near[k].y, near[k].x);
  }
}
