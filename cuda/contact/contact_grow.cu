// SPDX-License-Identifier: MIT
// One thread per sphere: grows it by its skin, for the search that lists near pairs. All spheres are awake afterwards.
#include "cuda/contact/contact_rest.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) contact_grow(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i == 0u) {
    buf.fault[LEFT_SKIN] = 0xFFFFFFFFu;
    buf.fault[STEPS_DONE] = 0u;
  }
  if (i >= p.n) return;
  vec4 sphere = buf.position[i];
  if (is_too_far(sphere, p.contact)) record_fault(buf, FAULT_RANGE, i);
  buf.grown[i] = grown_sphere(sphere, p.contact);
  record_rest(p, buf, i, false);
}

Entry contact_grow_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_grow); }

}  // namespace spherepair
