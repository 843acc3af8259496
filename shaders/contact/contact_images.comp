#version 450
// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: puts the sphere of an image in the image's place. A pair of two
// images, whose spheres are another pair, becomes the pair (0, 0), which stands for none.
#define ONLY_GROUPS
#include "shaders/kernels.glsl"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_NEAR) restrict buffer NearBuffer { uvec2 near[]; };
layout(std430, binding = SLOT_IMAGE_OF) restrict readonly buffer ImageOfBuffer { uint image_of[]; };

void main() {
  uint pairs = p.search.near_pairs;
  for (uint k = group_index() * BLOCK + gl_LocalInvocationID.x; k < pairs; k += group_count() * BLOCK) {
    uvec2 pair = near[k];
    if (pair.x >= p.n) near[k] = uvec2(0u, 0u);
    if (pair.x < p.n && pair.y >= p.n) near[k] = uvec2(pair.x, image_of[1u + pair.y - p.n]);
  }
}
