// SPDX-License-Identifier: MIT
// One thread per sphere: one step of the method `anchored`, which touches only the spheres that may meet the plane.
#include "motion_state.cuh"

namespace spherepair {

template <typename Real>
__global__ void __launch_bounds__(SERVICE_BLOCK) bounce(Params p, World w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (i >= p.n || p.steps_done < w.due[i]) return;
  Anchor<Real> a = anchor_anew(load_anchor<Real>(p, w, i), p);
  Real* flight = static_cast<Real*>(w.flight) + i;
  flight[0] = a.speed;
  flight[size_t(p.n)] = a.age;
  w.since[i] = a.since;
  w.due[i] = next_due(a, p);
}

Entry bounce_kernel(uint, Variant variant) {
  return pick_precision(variant, [](auto kind) { return reinterpret_cast<Entry>(&bounce<decltype(kind)>); });
}

}  // namespace spherepair
