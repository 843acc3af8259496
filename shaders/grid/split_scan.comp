#version 450
// SPDX-License-Identifier: MIT
// One group: the numbers of spheres in the buckets become the places where these begin, a bucket a thread.
#include "shaders/buffers.glsl"
#include "shaders/grid/group_sum.glsl"

layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint bucket_cursor[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint own = bucket_cursor[lane];
  uint upto = sum_up_to(own);
  bucket_cursor[lane] = upto - own;
}
