#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: sorts its row, so that its impulses are added by ascending index of the other sphere.
#include "shaders/kernels.glsl"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_ROW) restrict buffer RowBuffer { uint row[]; };
layout(std430, binding = SLOT_ROW_LENGTH) restrict buffer RowLengthBuffer { uint row_length[]; };

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= p.n) return;
  uint length = row_length[i];
  for (uint k = 1u; k < length; ++k) {
    uint j = row[k * p.n + i];
    uint to = k;
    for (; to > 0u && row[(to - 1u) * p.n + i] > j; --to) row[to * p.n + i] = row[(to - 1u) * p.n + i];
    row[to * p.n + i] = j;
  }
}
