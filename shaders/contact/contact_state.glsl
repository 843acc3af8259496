// SPDX-License-Identifier: MIT
// Loads and stores a sphere whose state is in 64-bit integers (see layout.h). A shader may have 16 storage blocks, so a
// buffer that few kernels use is declared in those kernels.
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

// Records a fault. The lowest index is kept, so that the message names the same sphere in any order.
void record_fault(uint kind, uint i) {
  if (kind != FAULTS) atomicMin(fault[kind], i);
}
bool has_faults() { return any_fault(fault[FAULT_DEEP], fault[FAULT_FAST], fault[FAULT_RANGE]); }
