// SPDX-License-Identifier: MIT
// One thread per sphere: makes one step of motion with the plane. Clears the counts and totals of the last search if
// p.motion.clear_results is set.
#include "cuda/motion/motion_state.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <uint METHOD, typename Real>
__global__ void __launch_bounds__(BLOCK) move(Params p, KernelBuffers buf) {
  wait_first(p);  // CUDA only: of small steps, which get ready early
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (p.motion.clear_results != 0u) clear_results(p, buf, i);
  if (i >= p.n) return;
  store_sphere(p, buf, i, take_step(METHOD, load_sphere<Real>(p, buf, i), p.motion));
  grid_dependency_sync();  // CUDA only: the next launch needs the previous search done too
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
    case MotionMethod::leapfrog:
      break;
  }
  return nullptr;
}

}  // namespace spherepair
