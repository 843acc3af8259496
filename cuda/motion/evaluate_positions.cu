// SPDX-License-Identifier: MIT
// One thread per sphere: computes its position at this step by the method `anchored`. Before a collision step it also
// clears the results.
#include "cuda/motion/motion_state.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <typename Real>
__global__ void __launch_bounds__(BLOCK) evaluate_positions(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (p.motion.clear_results != 0u) clear_results(p, buf, i);
  if (i >= p.n) return;
  Moving<Real> s = evaluate_sphere(load_anchor<Real>(p, buf, i), motion_params(p));
  if (p.motion.whole_state != 0u) {
    store_sphere(p, buf, i, s);
  } else {
    buf.position[i] = vec4{nearest(s.x), nearest(s.y), nearest(s.z), s.radius};
  }
}

Entry evaluate_positions_kernel(uint, Variant variant) {
  return pick_precision(variant,
                        [](auto kind) { return reinterpret_cast<Entry>(&evaluate_positions<decltype(kind)>); });
}

}  // namespace spherepair
