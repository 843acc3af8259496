// SPDX-License-Identifier: MIT
// A moving sphere, its free flight, and the methods that reverse its velocity when a step ends below the plane: the
// paper's and its relatives. Written once for state in float, Two and double.
#ifndef SPHEREPAIR_FLIGHT_H
#define SPHEREPAIR_FLIGHT_H

#include "common/shared/exact.h"
#include "common/shared/layout.h"
#include "common/shared/two.h"
#include "common/shared/wide.h"

ANY_REAL struct Moving {
  Real x, y, z, vx, vy, vz;
  float radius;
};

// Whether the sphere's lowest point is below the plane: y - r < plane in real arithmetic. Rounding is monotonic, so
// only equality after rounding needs the integers.
FN bool below_plane(float y, float r, float plane) {
  EXACT float bottom = y - r;
  if (bottom != plane) return bottom < plane;
  return sum_negative(float_bits(y), float_bits(r) ^ 0x80000000u, float_bits(plane) ^ 0x80000000u);
}
FN bool below_plane(Two y, float r, float plane) { return below(y, exact_sum(plane, r)); }
FN bool below_plane(double y, float r, float plane) { return below(y, plus(double(plane), double(r))); }

// Returns P + v*dt + g*dt*dt/2 along one axis (the paper's equation 1). term = g*dt*dt/2 is computed once, on the host.
ANY_REAL FN Real advance(Real position, Real velocity, Real dt, Real term) {
  return snapped(plus(plus(position, times(velocity, dt)), term));
}
ANY_REAL FN Real drift(Real position, Real velocity, Real dt) { return snapped(plus(position, times(velocity, dt))); }

// Makes one step without a plane.
ANY_REAL FN Moving OF_REAL fly(Moving OF_REAL from, MotionParams m) {
  Real dt = widened(m.dt, from.y);
  Moving OF_REAL next = from;
  next.x = drift(from.x, from.vx, dt);
  next.y = advance(from.y, from.vy, dt, constant(m.half_gravity_dt2, from.y));
  next.z = drift(from.z, from.vz, dt);
  next.vx = snapped(from.vx);
  next.vy = snapped(plus(from.vy, constant(m.gravity_dt, from.y)));
  next.vz = snapped(from.vz);
  return next;
}

ANY_REAL FN Real turned(Real velocity, MotionParams m) {
  return snapped(negated(times(velocity, widened(m.restitution, velocity))));
}

// Code 1 of the paper, to the letter: on contact it reverses the old velocity, times the restitution, and repeats the
// step from the old position. Spheres sink for restitution < 1 and gain energy at 1; both belong to the method.
ANY_REAL FN Moving OF_REAL move_paper(Moving OF_REAL from, MotionParams m) {
  Moving OF_REAL next = fly(from, m);
  if (below_plane(next.y, from.radius, m.plane)) {
    next.vy = turned(from.vy, m);
    next.y = advance(from.y, next.vy, widened(m.dt, from.y), constant(m.half_gravity_dt2, from.y));
  }
  return next;
}

// Returns the lowest height at which a sphere does not reach below the plane: plane + r, rounded upwards.
FN float ground(float r, float plane, float kind) {
  Two height = exact_sum(plane, r);
  kind = height.hi;
  if (!(snap(height.lo) > 0.0f)) return kind;
  return bits_float((float_bits(kind) & 0x80000000u) != 0u ? float_bits(kind) - 1u : float_bits(kind) + 1u);
}
FN Two ground(float r, float plane, Two kind) {
  kind = exact_sum(plane, r);
  return kind;
}
FN double ground(float r, float plane, double kind) {
  kind = plus(double(plane), double(r));
  return kind;
}

// Does the same, but moves a sphere that still ends below the plane onto it.
ANY_REAL FN Moving OF_REAL move_clamped(Moving OF_REAL from, MotionParams m) {
  Moving OF_REAL next = move_paper(from, m);
  if (below_plane(next.y, from.radius, m.plane)) next.y = ground(from.radius, m.plane, from.y);
  return next;
}

// Makes a step along y at constant velocity, with the same reversal on contact.
ANY_REAL FN Moving OF_REAL move_straight(Moving OF_REAL from, Real velocity, Moving OF_REAL next, MotionParams m) {
  Real dt = widened(m.dt, from.y);
  next.y = drift(from.y, velocity, dt);
  if (below_plane(next.y, from.radius, m.plane)) {
    next.vy = turned(from.vy, m);
    next.y = drift(from.y, next.vy, dt);
  }
  return next;
}

// The explicit Euler method: moves the sphere with its old velocity.
ANY_REAL FN Moving OF_REAL move_euler(Moving OF_REAL from, MotionParams m) {
  return move_straight(from, from.vy, fly(from, m), m);
}

// The semi-implicit Euler method, which is symplectic: moves the sphere with its new velocity.
ANY_REAL FN Moving OF_REAL move_symplectic(Moving OF_REAL from, MotionParams m) {
  Moving OF_REAL next = fly(from, m);
  return move_straight(from, next.vy, next, m);
}

#endif
