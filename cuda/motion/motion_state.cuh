// SPDX-License-Identifier: MIT
// Loads and stores the motion state of a sphere (see layout.h) in the number type Real: float, Two or double. float32
// state is the positions and velocities themselves.
#pragma once

#include "common/shared/anchor.h"
#include "common/shared/motion.h"
#include "cuda/kernels.cuh"

namespace spherepair {

// CUDA only: all parameters are a kernel argument
__device__ inline const MotionParams& motion_params(const Params& p) { return p.motion; }

template <typename Real>
__device__ inline Moving<Real> load_sphere(const Params& p, const KernelBuffers& buf, uint i) {
  const Real* wide = static_cast<const Real*>(buf.wide);
  vec4 at = buf.position[i];
  if constexpr (std::is_same_v<Real, float>) {
    vec4 v = buf.velocity[i];
    return Moving<Real>{at.x, at.y, at.z, v.x, v.y, v.z, at.w};
  } else {
    size_t n = p.n;
    return Moving<Real>{wide[i],          wide[n + i], wide[2u * n + i], wide[3u * n + i], wide[4u * n + i],
                        wide[5u * n + i], at.w};
  }
}

template <typename Real>
__device__ inline void store_sphere(const Params& p, const KernelBuffers& buf, uint i, Moving<Real> s) {
  Real* wide = static_cast<Real*>(buf.wide);
  buf.position[i] = vec4{nearest(s.x), nearest(s.y), nearest(s.z), s.radius};
  if constexpr (std::is_same_v<Real, float>) {
    buf.velocity[i] = vec4{s.vx, s.vy, s.vz, 0.0f};
  } else {
    size_t n = p.n;
    wide[i] = s.x;
    wide[n + i] = s.y;
    wide[2u * n + i] = s.z;
    wide[3u * n + i] = s.vx;
    wide[4u * n + i] = s.vy;
    wide[5u * n + i] = s.vz;
  }
}

template <typename Real>
__device__ inline Anchor<Real> load_anchor(const Params& p, const KernelBuffers& buf, uint i) {
  const Real* flight = static_cast<const Real*>(buf.flight);
  vec4 v = buf.velocity[i];
  return Anchor<Real>{buf.anchor[i], snap(v.x), snap(v.z), flight[i], flight[size_t(p.n) + i], buf.since[i]};
}

// Calls pick(Real{}) with the number type of this precision.
template <typename Pick>
Entry pick_precision(Variant variant, Pick pick) {
  if (variant.motion.precision == Precision::compensated) return pick(Two{});
  if (variant.motion.precision == Precision::float64) return pick(double{});
  return pick(float{});
}

}  // namespace spherepair
