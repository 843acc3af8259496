#version 450
// SPDX-License-Identifier: MIT
// One group: the numbers of spheres in the buckets become the places where these begin, a bucket a thread.
#include "buffers.glsl"

layout(std430, binding = SLOT_BUCKET) restrict buffer BucketBuffer { uint next_place[]; };
layout(local_size_x = BLOCK) in;
shared uint sums[BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint own = next_place[lane];
  uint upto = own;
  for (uint step = 1u; step < BLOCK; step *= 2u) {
    sums[lane] = upto;
    barrier();
    if (lane >= step) upto += sums[lane - step];
    barrier();
  }
  next_place[lane] = upto - own;
}
