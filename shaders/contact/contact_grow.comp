#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: grows it by its skin, for the search that lists near pairs. All spheres are awake afterwards.
// In a periodic box the images of spheres near its faces follow the n spheres, in any order; if there are more than
// image_capacity, only their number is right.
#include "shaders/contact/contact_rest.glsl"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_GROWN) restrict buffer GrownBuffer { vec4 grown[]; };
layout(std430, binding = SLOT_IMAGE_OF) restrict buffer ImageOfBuffer { uint image_of[]; };

void add_images(uint i, vec4 sphere) {
  uint faces = image_faces(sphere, p.contact);
  if (faces == 0u) return;
  Body s = load_place(i);
  for (uint image = FIRST_IMAGE; image < END_OF_IMAGES; ++image) {
    if (!image_is_needed(image, faces)) continue;
    uint k = atomicAdd(image_of[0], 1u);
    if (k >= p.image_capacity) continue;
    image_of[1u + k] = i;
    grown[p.n + k] = sphere_of_image(s, image, sphere.w, p.contact);
  }
}

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i == 0u) {
    fault[LEFT_SKIN] = 0xFFFFFFFFu;
    fault[STEPS_DONE] = 0u;
  }
  if (i >= p.n) return;
  vec4 sphere = position[i];
  if (is_too_far(sphere, p.contact)) record_fault(FAULT_RANGE, i);
  vec4 larger_sphere = grown_sphere(sphere, p.contact);
  grown[i] = larger_sphere;
  record_rest(i, false);
  add_images(i, larger_sphere);
}
