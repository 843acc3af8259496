// SPDX-License-Identifier: MIT
// What the kernels of motion keep of each sphere (layout.h says where), for state in Real, which is one of float, Two
// and double: float32 state is the positions and velocities themselves.
#define POSITION_ACCESS
#include "shaders/buffers.glsl"

#include "common/shared/anchor.h"
#include "common/shared/motion.h"

layout(std430, binding = SLOT_WIDE) restrict buffer WideBuffer { Real wide[]; };
layout(std430, binding = SLOT_ANCHOR) restrict readonly buffer AnchorBuffer { vec4 anchor[]; };
layout(std430, binding = SLOT_FLIGHT) restrict buffer FlightBuffer { Real flight[]; };
layout(std430, binding = SLOT_SINCE) restrict buffer SinceBuffer { uint since[]; };
layout(std430, binding = SLOT_NEXT_EVENT) buffer NextEventBuffer { uint next_event[]; };

#if PRECISION == PRECISION_FLOAT32
Moving load_sphere(uint i) {
  vec4 at = position[i];
  vec4 v = velocity[i];
  return Moving(at.x, at.y, at.z, v.x, v.y, v.z, at.w);
}
void store_sphere(uint i, Moving s) {
  position[i] = vec4(s.x, s.y, s.z, s.radius);
  velocity[i] = vec4(s.vx, s.vy, s.vz, 0.0f);
}
#else
Moving load_sphere(uint i) {
  return Moving(wide[i], wide[p.n + i], wide[2u * p.n + i], wide[3u * p.n + i], wide[4u * p.n + i], wide[5u * p.n + i],
                position[i].w);
}
void store_sphere(uint i, Moving s) {
  position[i] = vec4(nearest(s.x), nearest(s.y), nearest(s.z), s.radius);
  wide[i] = s.x;
  wide[p.n + i] = s.y;
  wide[2u * p.n + i] = s.z;
  wide[3u * p.n + i] = s.vx;
  wide[4u * p.n + i] = s.vy;
  wide[5u * p.n + i] = s.vz;
}
#endif

Anchor load_anchor(uint i) {
  vec4 v = velocity[i];
  return Anchor(anchor[i], snap(v.x), snap(v.z), flight[i], flight[p.n + i], since[i]);
}
