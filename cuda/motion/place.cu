// SPDX-License-Identifier: MIT
// One thread per sphere: where the method `anchored` has it at this step; without the whole state, for a collision
// step, whose results are cleared.
#include "cuda/motion/motion_state.cuh"

namespace spherepair {

template <typename Real>
__global__ void __launch_bounds__(SERVICE_BLOCK) place(Params p, World w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (p.whole_state == 0u) clear_results(p, w, i);
  if (i >= p.n) return;
  Moving<Real> s = place_sphere(load_anchor<Real>(p, w, i), p);
  if (p.whole_state != 0u) {
    store_sphere(p, w, i, s);
  } else {
    w.position[i] = {nearest(s.x), nearest(s.y), nearest(s.z), s.radius};
  }
}

Entry place_kernel(uint, Variant variant) {
  return pick_precision(variant, [](auto kind) { return reinterpret_cast<Entry>(&place<decltype(kind)>); });
}

}  // namespace spherepair
