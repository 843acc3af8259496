// SPDX-License-Identifier: MIT
// Loads and stores the motion state of a sphere (see layout.h) in the number type Real: float, Two or double. float32
// state is the positions and velocities themselves.
#define POSITION_ACCESS
#include "shaders/kernels.glsl"

#include "common/shared/anchor.h"
#include "common/shared/motion.h"

layout(std430, binding = SLOT_WIDE) restrict buffer WideBuffer { Real wide[]; };
layout(std430, binding = SLOT_ANCHOR) restrict readonly buffer AnchorBuffer { vec4 anchor[]; };
layout(std430, binding = SLOT_FLIGHT) restrict buffer FlightBuffer { Real flight[]; };
layout(std430, binding = SLOT_SINCE) restrict buffer SinceBuffer { uint since[]; };
layout(std430, binding = SLOT_NEXT_EVENT) buffer NextEventBuffer { uint next_event[]; };

// GLSL only from here: the steps done change with every launch, so they are a uniform outside the block
layout(location = STEPS_LOCATION) uniform uint steps_done;

MotionParams motion_params() {
  MotionParams motion = p.motion;
  motion.steps_done = steps_done;
  return motion;
}
// until here

Moving load_sphere(uint i) {
  vec4 at = position[i];
#if PRECISION == PRECISION_FLOAT32
  vec4 v = velocity[i];
  return Moving(at.x, at.y, at.z, v.x, v.y, v.z, at.w);
#else
  uint n = p.n;
  return Moving(wide[i], wide[n + i], wide[2u * n + i], wide[3u * n + i], wide[4u * n + i], wide[5u * n + i], at.w);
#endif
}

void store_sphere(uint i, Moving s) {
  position[i] = vec4(nearest(s.x), nearest(s.y), nearest(s.z), s.radius);
#if PRECISION == PRECISION_FLOAT32
  velocity[i] = vec4(s.vx, s.vy, s.vz, 0.0f);
#else
  uint n = p.n;
  wide[i] = s.x;
  wide[n + i] = s.y;
  wide[2u * n + i] = s.z;
  wide[3u * n + i] = s.vx;
  wide[4u * n + i] = s.vy;
  wide[5u * n + i] = s.vz;
#endif
}

Anchor load_anchor(uint i) {
  vec4 v = velocity[i];
  return Anchor(anchor[i], snap(v.x), snap(v.z), flight[i], flight[p.n + i], since[i]);
}
