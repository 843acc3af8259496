// SPDX-License-Identifier: MIT
// Loads and stores a sphere whose state is in 64-bit integers (see layout.h), and adds impulses to it in any order.
#pragma once

#include "common/shared/contact.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__device__ inline float radius_of(const Params& p, const KernelBuffers& buf, uint i) {
  return p.radius != 0.0f ? p.radius : buf.position[i].w;  // equal radii need no load
}

__device__ inline Body load_place(const Params& p, const KernelBuffers& buf, uint i) {
  const int64_t* wide = static_cast<const int64_t*>(buf.wide);
  size_t n = p.n;
  return Body{wide[i], wide[n + i], wide[2u * n + i], 0l, 0l, 0l, radius_of(p, buf, i)};
}
__device__ inline Body with_momentum(const Params& p, const KernelBuffers& buf, Body s, uint i) {
  const int64_t* wide = static_cast<const int64_t*>(buf.wide);
  size_t n = p.n;
  return Body{s.x, s.y, s.z, wide[3u * n + i], wide[4u * n + i], wide[5u * n + i], s.radius};
}

__device__ inline void store_body(const Params& p, const KernelBuffers& buf, uint i, Body s, float mobility) {
  int64_t* wide = static_cast<int64_t*>(buf.wide);
  size_t n = p.n;
  wide[i] = s.x;
  wide[n + i] = s.y;
  wide[2u * n + i] = s.z;
  wide[3u * n + i] = s.px;
  wide[4u * n + i] = s.py;
  wide[5u * n + i] = s.pz;
  buf.position[i] = centre_of(s, p.contact);
  buf.velocity[i] = velocity_of(s, mobility, p.contact);
}

// A 64-bit sum.
__device__ inline void add_to_impulse(const KernelBuffers& buf, size_t k, int64_t value) {
  // CUDA only from here: its atomic is of unsigned numbers
  unsigned long long* sum = reinterpret_cast<unsigned long long*>(&buf.impulse[k]);
  atomicAdd(sum, static_cast<unsigned long long>(value));
  // until here
}

__device__ inline void add_impulse(const Params& p, const KernelBuffers& buf, uint i, int64_t x, int64_t y, int64_t z) {
  size_t n = p.n;
  add_to_impulse(buf, i, x);
  add_to_impulse(buf, n + i, y);
  add_to_impulse(buf, 2u * n + i, z);
}

// The sum of the impulses that were added; the next step begins with 0.
__device__ inline Push take_impulse(const Params& p, const KernelBuffers& buf, uint i) {
  size_t n = p.n;
  Push sum = Push{buf.impulse[i], buf.impulse[n + i], buf.impulse[2u * n + i], FAULTS};
  if (sum.x != 0l || sum.y != 0l || sum.z != 0l) {
    buf.impulse[i] = 0l;
    buf.impulse[n + i] = 0l;
    buf.impulse[2u * n + i] = 0l;
  }
  return sum;
}

// The lowest index is kept, so that the message names the same sphere in any order.
__device__ inline void record_fault(const KernelBuffers& buf, uint kind, uint i) {
  if (kind != FAULTS) atomicMin(&buf.fault[kind], i);
}

}  // namespace spherepair
