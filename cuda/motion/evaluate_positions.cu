// SPDX-License-Identifier: MIT
// One thread per sphere: where the method `anchored` has it at this step; without the whole state, for a collision
// step, whose results are cleared.
#include "cuda/motion/motion_state.cuh"

namespace spherepair {

template <typename Real>
__global__ void __launch_bounds__(SERVICE_BLOCK) evaluate_positions(Params p, KernelBuffers w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (p.whole_state == 0u) clear_results(p, w, i);
  if (i >= p.n) return;
  Moving<Real> s = evaluate_sphere(load_anchor<Real>(p, w, i), p);
  if (p.whole_state != 0u) {
    store_sphere(p, w, i, s);
  } else {
    w.position[i] = {nearest(s.x), nearest(s.y), nearest(s.z), s.radius};
  }
}

Entry evaluate_positions_kernel(uint, Variant variant) {
  return pick_precision(variant,
                        [](auto kind) { return reinterpret_cast<Entry>(&evaluate_positions<decltype(kind)>); });
}

}  // namespace spherepair
