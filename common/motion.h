// SPDX-License-Identifier: MIT
// The motion of one sphere, as every backend computes it: the same bits on every machine.
#ifndef SPHEREPAIR_MOTION_H
#define SPHEREPAIR_MOTION_H

#include "exact.h"
#include "layout.h"

struct Moving {
  vec4 position;
  vec4 velocity;
};

// Components below 2^-64 and -0 become +0, so that a backend that flushes denormals cannot show it.
FN float snap(float x) { return (float_bits(x) & 0x7FFFFFFFu) < 0x1F800000u ? 0.0f : x; }

// Whether the sphere's lowest point is below the plane: y - r < plane in real arithmetic. Rounding is monotonic, so
// only equality after rounding needs the integers.
FN bool below_plane(float y, float r, float plane) {
  EXACT float bottom = y - r;
  if (bottom != plane) return bottom < plane;
  return sum_negative(float_bits(y), float_bits(r) ^ 0x80000000u, float_bits(plane) ^ 0x80000000u);
}

// P + v*dt + g*dt*dt/2 along one axis (the paper's equation 1); term = g*dt*dt/2 is computed once, on the host.
FN float advance(float position, float velocity, float dt, float term) {
  EXACT float travelled = velocity * dt;
  EXACT float moved = position + travelled;
  EXACT float fallen = moved + term;
  return snap(fallen);
}

// Code 1 of the paper, to the letter: on contact the old velocity is turned round, times the restitution, and the step
// is taken again from the old position. It sinks for restitution < 1 and gains energy at 1; both belong to the method.
FN Moving move_paper(vec4 position, vec4 velocity, Params p) {
  Moving next = {position, velocity};
  EXACT float faster = velocity.y + p.gravity_dt;
  next.position.x = advance(position.x, velocity.x, p.dt, 0.0f);
  next.position.y = advance(position.y, velocity.y, p.dt, p.half_gravity_dt2);
  next.position.z = advance(position.z, velocity.z, p.dt, 0.0f);
  next.velocity.x = snap(velocity.x);
  next.velocity.y = snap(faster);
  next.velocity.z = snap(velocity.z);
  if (below_plane(next.position.y, position.w, p.plane)) {
    EXACT float turned = velocity.y * p.restitution;
    next.velocity.y = snap(-turned);
    next.position.y = advance(position.y, next.velocity.y, p.dt, p.half_gravity_dt2);
  }
  return next;
}

#endif
