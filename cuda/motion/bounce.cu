// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_BOUNCER spheres: makes a step of the method `anchored`, which handles only the spheres
// that may reach the plane. A group compacts these into a list first, so that the few that bounce share subgroups
// instead of delaying one each.
#include "cuda/motion/motion_state.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <typename Real>
__global__ void __launch_bounds__(BLOCK) bounce(Params p, KernelBuffers buf) {
  __shared__ uint found;
  __shared__ uint bouncing[SPHERES_PER_BOUNCER * BLOCK];
  Real* flight = static_cast<Real*>(buf.flight);
  const uvec4* next_event_vector = reinterpret_cast<const uvec4*>(buf.next_event);
  uint lane = threadIdx.x;
  uint first = group_index(p) * (SPHERES_PER_BOUNCER / 4) * BLOCK + lane;
  uint now = p.motion.whole_state == 0u ? motion_params(p).steps_done : NO_EVENT - 1u;
  if (lane == 0u) found = 0u;
  __syncthreads();
  for (uint v = 0u; v < SPHERES_PER_BOUNCER / 4; ++v) {
    uint i = 4u * (first + v * BLOCK);
    if (i >= p.n) break;
    uvec4 event_step = next_event_vector[i / 4u];
    if (now >= event_step.x) bouncing[atomicAdd(&found, 1u)] = i;
    if (now >= event_step.y && i + 1u < p.n) bouncing[atomicAdd(&found, 1u)] = i + 1u;
    if (now >= event_step.z && i + 2u < p.n) bouncing[atomicAdd(&found, 1u)] = i + 2u;
    if (now >= event_step.w && i + 3u < p.n) bouncing[atomicAdd(&found, 1u)] = i + 3u;
  }
  __syncthreads();
  for (uint k = lane; k < found; k += BLOCK) {
    uint i = bouncing[k];
    Anchor<Real> a = anchor_anew(load_anchor<Real>(p, buf, i), motion_params(p));
    flight[i] = a.speed;
    flight[size_t(p.n) + i] = a.age;
    buf.since[i] = a.since;
    buf.next_event[i] = next_event_step(a, motion_params(p));
  }
  grid_dependency_sync();  // CUDA only: the next launch needs the previous search done too
}

Entry bounce_kernel(uint, Variant variant) {
  return pick_precision(variant, [](auto kind) { return reinterpret_cast<Entry>(&bounce<decltype(kind)>); });
}

}  // namespace spherepair
