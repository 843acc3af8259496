#version 450
// SPDX-License-Identifier: MIT
// One thread per four cells or one bucket: clears the counts, and the totals.
#include "shaders/kernels.glsl"

layout(std430, binding = SLOT_CELL) restrict writeonly buffer CellBuffer { uvec4 cell[]; };
layout(std430, binding = SLOT_BUCKET) restrict writeonly buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint k = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (p.sort.buckets == 0u && k <= (p.grid.cell_slots + 1u) / 4u) cell[k] = uvec4(0u, 0u, 0u, 0u);
  if (k < SUMMARY_SLOTS * SUMMARY_WORDS) summary[k] = 0u;
  if (k < p.sort.bucket_words) bucket_cursor[k] = 0u;
}
