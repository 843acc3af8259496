// SPDX-License-Identifier: MIT
// Loads and stores a sphere whose state is in 64-bit integers (see layout.h), and adds impulses to it in any order.
#define POSITION_ACCESS
#include "shaders/kernels.glsl"

#include "common/shared/contact.h"
#include "common/shared/skin.h"

layout(std430, binding = SLOT_AXIS) restrict buffer AxisBuffer { Axis of[]; }
axis[3];
layout(std430, binding = SLOT_FAULT) restrict buffer FaultBuffer { uint fault[]; };
layout(std430, binding = SLOT_GROWN) restrict buffer GrownBuffer { vec4 grown[]; };
layout(std430, binding = SLOT_NEAR) restrict readonly buffer NearBuffer { uvec2 near[]; };

float radius_of(uint i) {
  return p.radius != 0.0f ? p.radius : position[i].w;  // equal radii need no load
}

// Without momentum, which contacts need only for a damper.
Body load_place(uint i) {
  return Body(axis[0].of[i].position, axis[1].of[i].position, axis[2].of[i].position, 0l, 0l, 0l, radius_of(i));
}
Body load_body(uint i) {
  Axis x = axis[0].of[i];
  Axis y = axis[1].of[i];
  Axis z = axis[2].of[i];
  return Body(x.position, y.position, z.position, x.momentum, y.momentum, z.momentum, radius_of(i));
}

void store_body(uint i, Body s, float mobility) {
  axis[0].of[i] = Axis(s.x, s.px);
  axis[1].of[i] = Axis(s.y, s.py);
  axis[2].of[i] = Axis(s.z, s.pz);
  position[i] = centre_of(s, p.contact);
  velocity[i] = velocity_of(s, mobility, p.contact);
}

// GLSL only from here: CUDA has the atomic
// 64-bit sums. Without 64-bit atomics by two of 32 bits, exact once all are done: exactly one addition sees each wrap
// of the low word.
#ifdef ATOMICS_64
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseBuffer { int64_t of[]; }
impulse[3];
int64_t impulse_of(uint k, uint i) { return impulse[k].of[i]; }
void clear_impulse(uint k, uint i) { impulse[k].of[i] = 0l; }
void add_to_impulse(uint k, uint i, int64_t value) { atomicAdd(impulse[k].of[i], value); }
#else
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseBuffer { uvec2 of[]; }
impulse[3];
int64_t impulse_of(uint k, uint i) {
  uvec2 words = impulse[k].of[i];
  return int64_t(uint64_t(words.y) << 32 | uint64_t(words.x));
}
void clear_impulse(uint k, uint i) { impulse[k].of[i] = uvec2(0u); }
void add_to_impulse(uint k, uint i, int64_t value) {
  uint low = uint(uint64_t(value) & 0xFFFFFFFFul);
  uint before = atomicAdd(impulse[k].of[i].x, low);
  uint high = uint(uint64_t(value) >> 32) + (before + low < before ? 1u : 0u);
  if (high != 0u) atomicAdd(impulse[k].of[i].y, high);
}
#endif
// until here

void add_impulse(uint i, int64_t x, int64_t y, int64_t z) {
  add_to_impulse(0u, i, x);
  add_to_impulse(1u, i, y);
  add_to_impulse(2u, i, z);
}

// The sum of the impulses that were added; the next step begins with 0.
Push take_impulse(uint i) {
  Push sum = Push(impulse_of(0u, i), impulse_of(1u, i), impulse_of(2u, i), FAULTS);
  if (sum.x != 0l || sum.y != 0l || sum.z != 0l) {
    clear_impulse(0u, i);
    clear_impulse(1u, i);
    clear_impulse(2u, i);
  }
  return sum;
}

// The lowest index is kept, so that the message names the same sphere in any order.
void record_fault(uint kind, uint i) {
  if (kind != FAULTS) atomicMin(fault[kind], i);
}
