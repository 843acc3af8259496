// SPDX-License-Identifier: MIT
// What the kernels of motion keep of each sphere (layout.h says where), for state in Real, which is one of float, Two
// and double: float32 state is the positions and velocities themselves.
#pragma once

#include "common/shared/anchor.h"
#include "common/shared/motion.h"
#include "cuda/kernels.cuh"

namespace spherepair {

template <typename Real>
__device__ inline Moving<Real> load_sphere(Params p, KernelBuffers w, uint i) {
  vec4 at = w.position[i];
  if constexpr (std::is_same_v<Real, float>) {
    vec4 v = w.velocity[i];
    return {at.x, at.y, at.z, v.x, v.y, v.z, at.w};
  } else {
    const Real* wide = static_cast<const Real*>(w.wide) + i;
    size_t n = p.n;
    return {wide[0], wide[n], wide[2 * n], wide[3 * n], wide[4 * n], wide[5 * n], at.w};
  }
}

template <typename Real>
__device__ inline void store_sphere(Params p, KernelBuffers w, uint i, Moving<Real> s) {
  w.position[i] = {nearest(s.x), nearest(s.y), nearest(s.z), s.radius};
  if constexpr (std::is_same_v<Real, float>) {
    w.velocity[i] = {s.vx, s.vy, s.vz, 0.0f};
  } else {
    Real* wide = static_cast<Real*>(w.wide) + i;
    size_t n = p.n;
    wide[0] = s.x;
    wide[n] = s.y;
    wide[2 * n] = s.z;
    wide[3 * n] = s.vx;
    wide[4 * n] = s.vy;
    wide[5 * n] = s.vz;
  }
}

template <typename Real>
__device__ inline Anchor<Real> load_anchor(Params p, KernelBuffers w, uint i) {
  const Real* flight = static_cast<const Real*>(w.flight) + i;
  vec4 v = w.velocity[i];
  return {w.anchor[i], snap(v.x), snap(v.z), flight[0], flight[size_t(p.n)], w.since[i]};
}

// Calls pick(Real{}) with the number type of this precision.
template <typename Pick>
Entry pick_precision(Variant variant, Pick pick) {
  if (variant.motion.precision == Precision::compensated) return pick(Two{});
  if (variant.motion.precision == Precision::float64) return pick(double{});
  return pick(float{});
}

}  // namespace spherepair
