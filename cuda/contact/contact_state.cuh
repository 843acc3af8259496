// SPDX-License-Identifier: MIT
// Loads and stores a sphere whose state is in 64-bit integers (see layout.h).
#pragma once

#include "common/shared/contact/contact.h"
#include "common/shared/contact/skin.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__device__ inline float radius_of(const Params& p, const KernelBuffers& buf, uint i) {
  return p.radius != 0.0f ? p.radius : buf.position[i].w;  // equal radii need no load
}

// CUDA only from here: GLSL has i64vec2 in place of Axis, for its alignment to 16 bytes
__device__ inline int64_t load_position(const KernelBuffers& buf, uint k, uint i) { return buf.axis[k].of[i].position; }
__device__ inline Axis load_axis(const KernelBuffers& buf, uint k, uint i) { return buf.axis[k].of[i]; }
__device__ inline void store_axis(const KernelBuffers& buf, uint k, uint i, int64_t at, int64_t momentum) {
  buf.axis[k].of[i] = Axis{at, momentum};
}
// until here

// Loads a sphere without its momentum, which contacts need only for a damper.
__device__ inline Body load_place(const Params& p, const KernelBuffers& buf, uint i) {
  return Body{load_position(buf, 0u, i), load_position(buf, 1u, i), load_position(buf, 2u, i), 0l, 0l, 0l,
              radius_of(p, buf, i)};
}
__device__ inline Body load_body(const Params& p, const KernelBuffers& buf, uint i) {
  Axis x = load_axis(buf, 0u, i);
  Axis y = load_axis(buf, 1u, i);
  Axis z = load_axis(buf, 2u, i);
  return Body{x.position, y.position, z.position, x.momentum, y.momentum, z.momentum, radius_of(p, buf, i)};
}

__device__ inline void store_body(const Params& p, const KernelBuffers& buf, uint i, Body s, vec4 speeds) {
  store_axis(buf, 0u, i, s.x, s.px);
  store_axis(buf, 1u, i, s.y, s.py);
  store_axis(buf, 2u, i, s.z, s.pz);
  buf.position[i] = centre_of(s, p.contact);
  buf.velocity[i] = velocity_of(speeds, p.contact);
}

// Records a fault. The lowest index is kept, so that the message names the same sphere in any order.
__device__ inline void record_fault(const KernelBuffers& buf, uint kind, uint i) {
  if (kind != FAULTS) atomicMin(&buf.fault[kind], i);
}
__device__ inline bool has_faults(const KernelBuffers& buf) {
  return any_fault(buf.fault[FAULT_DEEP], buf.fault[FAULT_FAST], buf.fault[FAULT_RANGE]);
}

}  // namespace spherepair
