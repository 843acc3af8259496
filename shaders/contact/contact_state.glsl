// SPDX-License-Identifier: MIT
// Loads and stores a sphere whose state is in 64-bit integers (see layout.h), and adds impulses to it in any order. A
// shader may have 16 storage blocks, so a buffer that few kernels use is declared in those kernels.
#define POSITION_ACCESS
#include "shaders/kernels.glsl"

#include "common/shared/contact/contact.h"
#include "common/shared/contact/skin.h"

layout(std430, binding = SLOT_AXIS) restrict buffer AxisBuffer { i64vec2 of[]; }  // an Axis, aligned to 16 bytes
axis[3];
layout(std430, binding = SLOT_FAULT) restrict buffer FaultBuffer { uint fault[]; };

float radius_of(uint i) {
  return p.radius != 0.0f ? p.radius : position[i].w;  // equal radii need no load
}

// GLSL only from here: i64vec2 in place of Axis, for its alignment to 16 bytes
int64_t load_position(uint k, uint i) { return axis[k].of[i].x; }
Axis load_axis(uint k, uint i) {
  i64vec2 loaded = axis[k].of[i];
  return Axis(loaded.x, loaded.y);
}
void store_axis(uint k, uint i, int64_t at, int64_t momentum) { axis[k].of[i] = i64vec2(at, momentum); }
// until here

// Loads a sphere without its momentum, which contacts need only for a damper.
Body load_place(uint i) {
  return Body(load_position(0u, i), load_position(1u, i), load_position(2u, i), 0l, 0l, 0l, radius_of(i));
}
Body load_body(uint i) {
  Axis x = load_axis(0u, i);
  Axis y = load_axis(1u, i);
  Axis z = load_axis(2u, i);
  return Body(x.position, y.position, z.position, x.momentum, y.momentum, z.momentum, radius_of(i));
}

void store_body(uint i, Body s, vec4 speeds) {
  store_axis(0u, i, s.x, s.px);
  store_axis(1u, i, s.y, s.py);
  store_axis(2u, i, s.z, s.pz);
  position[i] = centre_of(s, p.contact);
  velocity[i] = velocity_of(speeds, p.contact);
}

// GLSL only from here: CUDA has the atomic
// Without 64-bit atomics, a sum is two words of 32 bits. It is exact once all additions are done, because exactly one
// of them sees each wrap of the low word.
#if defined ATOMICS_64
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseBuffer { int64_t of[]; }
impulse[3];
int64_t load_from_impulse(uint k, uint i) { return impulse[k].of[i]; }
void clear_impulse(uint k, uint i, int64_t sum) {
  if (sum != 0l) impulse[k].of[i] = 0l;
}
void add_to_impulse(uint k, uint i, float value) { atomicAdd(impulse[k].of[i], integer_of(value)); }
#else
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseBuffer { uvec2 of[]; }
impulse[3];
int64_t load_from_impulse(uint k, uint i) {
  uvec2 words = impulse[k].of[i];
  return int64_t(uint64_t(words.y) << 32 | uint64_t(words.x));
}
void clear_impulse(uint k, uint i, int64_t sum) {
  if (sum != 0l) impulse[k].of[i] = uvec2(0u);
}
void add_to_impulse(uint k, uint i, float rounded_here) {
  int64_t value = integer_of(rounded_here);
  uint low = uint(uint64_t(value) & 0xFFFFFFFFul);
  uint before = atomicAdd(impulse[k].of[i].x, low);
  uint high = uint(uint64_t(value) >> 32) + (before + low < before ? 1u : 0u);
  if (high != 0u) atomicAdd(impulse[k].of[i].y, high);
}
#endif
// until here

void add_impulse(uint i, float x, float y, float z) {
  add_to_impulse(0u, i, x);
  add_to_impulse(1u, i, y);
  add_to_impulse(2u, i, z);
}

// Returns the sum of the impulses that were added.
Push load_impulse(uint i) {
  return Push(load_from_impulse(0u, i), load_from_impulse(1u, i), load_from_impulse(2u, i), FAULTS);
}
// Sets that sum to 0 for the next step.
void clear_impulses(uint i, Push sum) {
  clear_impulse(0u, i, sum.x);
  clear_impulse(1u, i, sum.y);
  clear_impulse(2u, i, sum.z);
}

// Records a fault. The lowest index is kept, so that the message names the same sphere in any order.
void record_fault(uint kind, uint i) {
  if (kind != FAULTS) atomicMin(fault[kind], i);
}
bool has_faults() { return any_fault(fault[FAULT_DEEP], fault[FAULT_FAST], fault[FAULT_RANGE]); }
