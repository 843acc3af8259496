// SPDX-License-Identifier: MIT
// One thread per sphere: one step of motion and the plane, and the results of the last step cleared where they are by
// the number of the sphere.
#include "cuda/motion/motion_state.cuh"

namespace spherepair {

template <uint METHOD, typename Real>
__global__ void __launch_bounds__(SERVICE_BLOCK) move(Params p, KernelBuffers w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (p.in_cells == 0u) clear_results(p, w, i);
  if (i >= p.n) return;
  store_sphere(p, w, i, take_step(METHOD, load_sphere<Real>(p, w, i), p));
  grid_dependency_sync();
}

template <uint METHOD>
Entry move_by(Variant variant) {
  return pick_precision(variant, [](auto kind) { return reinterpret_cast<Entry>(&move<METHOD, decltype(kind)>); });
}

Entry move_kernel(uint, Variant variant) {
  switch (variant.motion.method) {
    case MotionMethod::euler:
      return move_by<MOTION_EULER>(variant);
    case MotionMethod::symplectic:
      return move_by<MOTION_SYMPLECTIC>(variant);
    case MotionMethod::paper:
      return move_by<MOTION_PAPER>(variant);
    case MotionMethod::paper_clamp:
      return move_by<MOTION_PAPER_CLAMP>(variant);
    case MotionMethod::impact_linear:
      return move_by<MOTION_IMPACT_LINEAR>(variant);
    case MotionMethod::impact:
      return move_by<MOTION_IMPACT>(variant);
    case MotionMethod::anchored:
      break;
  }
  return nullptr;
}

}  // namespace spherepair
