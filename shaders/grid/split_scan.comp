#version 450
// SPDX-License-Identifier: MIT
// One group, one thread per bucket: turns counts of spheres into begins by an exclusive prefix sum.
#include "shaders/grid/group_sum.glsl"
#include "shaders/kernels.glsl"

layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint own = bucket_cursor[lane];
  uint upto = sum_up_to(own);
  bucket_cursor[lane] = upto - own;
}
