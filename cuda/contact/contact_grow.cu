// SPDX-License-Identifier: MIT
// One thread per sphere: grows it by its skin, for the search that lists near pairs. All spheres are awake afterwards.
// In a periodic box the images of spheres near its faces follow the n spheres, in any order; if there are more than
// image_capacity, only their number is right.
#include "cuda/contact/contact_rest.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__device__ inline void add_images(const Params& p, const KernelBuffers& buf, uint i, vec4 sphere) {
  uint faces = image_faces(sphere, p.contact);
  if (faces == 0u) return;
  Body s = load_place(p, buf, i);
  for (uint image = FIRST_IMAGE; image < END_OF_IMAGES; ++image) {
    if (!image_is_needed(image, faces)) continue;
    uint k = atomicAdd(&buf.image_of[0], 1u);
    if (k >= p.image_capacity) continue;
    buf.image_of[1u + k] = i;
    buf.grown[p.n + k] = sphere_of_image(s, image, sphere.w, p.contact);
  }
}

__global__ void __launch_bounds__(BLOCK) contact_grow(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i == 0u) {
    buf.fault[LEFT_SKIN] = 0xFFFFFFFFu;
    buf.fault[STEPS_DONE] = 0u;
  }
  if (i >= p.n) return;
  vec4 sphere = buf.position[i];
  if (is_too_far(sphere, p.contact)) record_fault(buf, FAULT_RANGE, i);
  vec4 larger_sphere = grown_sphere(sphere, p.contact);
  buf.grown[i] = larger_sphere;
  record_rest(p, buf, i, false);
  add_images(p, buf, i, larger_sphere);
}

Entry contact_grow_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_grow); }

}  // namespace spherepair
