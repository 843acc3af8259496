// SPDX-License-Identifier: MIT
// Loads and stores a sphere whose state is in 64-bit integers (see layout.h), and adds impulses to it in any order.
#pragma once

#include "common/shared/contact/contact.h"
#include "common/shared/skin.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__device__ inline float radius_of(const Params& p, const KernelBuffers& buf, uint i) {
  return p.radius != 0.0f ? p.radius : buf.position[i].w;  // equal radii need no load
}

// Without momentum, which contacts need only for a damper.
__device__ inline Body load_place(const Params& p, const KernelBuffers& buf, uint i) {
  return Body{buf.axis[0].of[i].position, buf.axis[1].of[i].position, buf.axis[2].of[i].position, 0l, 0l, 0l,
              radius_of(p, buf, i)};
}
__device__ inline Body load_body(const Params& p, const KernelBuffers& buf, uint i) {
  Axis x = buf.axis[0].of[i];
  Axis y = buf.axis[1].of[i];
  Axis z = buf.axis[2].of[i];
  return Body{x.position, y.position, z.position, x.momentum, y.momentum, z.momentum, radius_of(p, buf, i)};
}

__device__ inline void store_body(const Params& p, const KernelBuffers& buf, uint i, Body s, float mobility) {
  buf.axis[0].of[i] = Axis{s.x, s.px};
  buf.axis[1].of[i] = Axis{s.y, s.py};
  buf.axis[2].of[i] = Axis{s.z, s.pz};
  buf.position[i] = centre_of(s, p.contact);
  buf.velocity[i] = velocity_of(s, mobility, p.contact);
}

// CUDA only from here: its atomic is of unsigned numbers
// 64-bit sums, or float32 sums to be rounded when they are taken.
template <bool FLOAT_SUMS>
__device__ inline int64_t take_from_impulse(const KernelBuffers& buf, uint k, uint i) {
  if constexpr (FLOAT_SUMS) {
    float* sum = reinterpret_cast<float*>(buf.impulse[k]) + i;
    const float taken = *sum;
    if (taken != 0.0f) *sum = 0.0f;
    return integer_of(taken);
  } else {
    const int64_t taken = buf.impulse[k][i];
    if (taken != 0) buf.impulse[k][i] = 0;
    return taken;
  }
}
__device__ inline void put_in_impulse(const KernelBuffers& buf, uint k, uint i, int64_t value) {
  buf.impulse[k][i] = value;
}
template <bool FLOAT_SUMS>
__device__ inline void add_to_impulse(const KernelBuffers& buf, uint k, uint i, float value) {
  if constexpr (FLOAT_SUMS) {
    atomicAdd(reinterpret_cast<float*>(buf.impulse[k]) + i, value);
  } else {
    unsigned long long* sum = reinterpret_cast<unsigned long long*>(&buf.impulse[k][i]);
    atomicAdd(sum, static_cast<unsigned long long>(integer_of(value)));
  }
}
// until here

template <bool FLOAT_SUMS>
__device__ inline void add_impulse(const KernelBuffers& buf, uint i, float x, float y, float z) {
  add_to_impulse<FLOAT_SUMS>(buf, 0u, i, x);
  add_to_impulse<FLOAT_SUMS>(buf, 1u, i, y);
  add_to_impulse<FLOAT_SUMS>(buf, 2u, i, z);
}

// The sum of the impulses that were added; the next step begins with 0.
template <bool FLOAT_SUMS>
__device__ inline Push take_impulse(const KernelBuffers& buf, uint i) {
  return Push{take_from_impulse<FLOAT_SUMS>(buf, 0u, i), take_from_impulse<FLOAT_SUMS>(buf, 1u, i),
              take_from_impulse<FLOAT_SUMS>(buf, 2u, i), FAULTS};
}

// The lowest index is kept, so that the message names the same sphere in any order.
__device__ inline void record_fault(const KernelBuffers& buf, uint kind, uint i) {
  if (kind != FAULTS) atomicMin(&buf.fault[kind], i);
}

}  // namespace spherepair
