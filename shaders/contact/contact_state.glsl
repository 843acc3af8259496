// SPDX-License-Identifier: MIT
// Loads and stores a sphere whose state is in 64-bit integers (see layout.h), and adds impulses to it in any order.
#define POSITION_ACCESS
#include "shaders/kernels.glsl"

#include "common/shared/contact.h"

layout(std430, binding = SLOT_WIDE) restrict buffer WideBuffer { int64_t wide[]; };
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseBuffer { int64_t impulse[]; };
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseWords { uint impulse_word[]; };
layout(std430, binding = SLOT_FAULT) restrict buffer FaultBuffer { uint fault[]; };
layout(std430, binding = SLOT_GROWN) restrict buffer GrownBuffer { vec4 grown[]; };
layout(std430, binding = SLOT_NEAR) restrict readonly buffer NearBuffer { uvec2 near[]; };

float radius_of(uint i) {
  return p.radius != 0.0f ? p.radius : position[i].w;  // equal radii need no load
}

Body load_place(uint i) {
  uint n = p.n;
  return Body(wide[i], wide[n + i], wide[2u * n + i], 0l, 0l, 0l, radius_of(i));
}
Body with_momentum(Body s, uint i) {
  uint n = p.n;
  return Body(s.x, s.y, s.z, wide[3u * n + i], wide[4u * n + i], wide[5u * n + i], s.radius);
}

void store_body(uint i, Body s, float mobility) {
  uint n = p.n;
  wide[i] = s.x;
  wide[n + i] = s.y;
  wide[2u * n + i] = s.z;
  wide[3u * n + i] = s.px;
  wide[4u * n + i] = s.py;
  wide[5u * n + i] = s.pz;
  position[i] = centre_of(s, p.contact);
  velocity[i] = velocity_of(s, mobility, p.contact);
}

// A 64-bit sum; without 64-bit atomics by two of 32 bits, exact once all are done: exactly one addition sees each wrap
// of the low word.
void add_to_impulse(uint k, int64_t value) {
  // GLSL only from here: CUDA has the atomic
#ifdef ATOMICS_64
  atomicAdd(impulse[k], value);
#else
  uint low = uint(uint64_t(value) & 0xFFFFFFFFul);
  uint before = atomicAdd(impulse_word[2u * k], low);
  uint high = uint(uint64_t(value) >> 32) + (before + low < before ? 1u : 0u);
  if (high != 0u) atomicAdd(impulse_word[2u * k + 1u], high);
#endif
  // until here
}

void add_impulse(uint i, int64_t x, int64_t y, int64_t z) {
  uint n = p.n;
  add_to_impulse(i, x);
  add_to_impulse(n + i, y);
  add_to_impulse(2u * n + i, z);
}

// The sum of the impulses that were added; the next step begins with 0.
Push take_impulse(uint i) {
  uint n = p.n;
  Push sum = Push(impulse[i], impulse[n + i], impulse[2u * n + i], FAULTS);
  if (sum.x != 0l || sum.y != 0l || sum.z != 0l) {
    impulse[i] = 0l;
    impulse[n + i] = 0l;
    impulse[2u * n + i] = 0l;
  }
  return sum;
}

// The lowest index is kept, so that the message names the same sphere in any order.
void record_fault(uint kind, uint i) {
  if (kind != FAULTS) atomicMin(fault[kind], i);
}
