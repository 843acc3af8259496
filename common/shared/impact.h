// SPDX-License-Identifier: MIT
// Methods that find the time of impact on the plane within a step. Gravity is constant, so between bounces a step is
// exact except for rounding: only the time of impact is unknown. Gravity must not point upwards. A sphere that starts
// below the plane is moved onto it.
#ifndef SPHEREPAIR_IMPACT_H
#define SPHEREPAIR_IMPACT_H

#include "common/shared/flight.h"

// Makes a step without a plane. The displacement is rounded before it is added to the position, whose ulp is far
// larger. So the same small terms are not rounded the same way in every step (in float32 30 times more accurate).
ANY_REAL FN Moving OF_REAL glide(Moving OF_REAL from, MotionParams m) {
  Moving OF_REAL next = fly(from, m);
  Real climbed = times(from.vy, widened(m.dt, from.y));
  next.y = snapped(plus(from.y, plus(climbed, constant(m.half_gravity_dt2, from.y))));
  return next;
}

// The time until a sphere reaches the plane, and its downward speed then.
ANY_REAL struct Fall { Real time, speed; };

// Solves height + velocity*t + g*t*t/2 = 0 from this height (>= 0) above the plane, without cancellation.
ANY_REAL FN Fall OF_REAL fall(Real height, Real velocity, MotionParams m) {
  Real zero = widened(0.0f, height);
  EXACT float twice_gravity = -2.0f * m.gravity;
  Real potential = times(widened(twice_gravity, height), height);
  Fall OF_REAL end = {zero, square_root(plus(times(velocity, velocity), potential))};
  if (below(velocity, zero)) {
    if (below(zero, height)) end.time = quotient(plus(height, height), minus(end.speed, velocity));
  } else {
    Real inverse = times(constant(m.seconds_per_speed, height), widened(0.5f, height));
    end.time = times(plus(velocity, end.speed), inverse);
  }
  return end;
}

// The last bounce so far: the time since, and the speed after it. A sphere at rest has speed 0.
ANY_REAL struct Rebound { Real time, speed; };

// Returns the last bounce of a sphere that leaves the plane upwards at `speed` and moves for `time`, after any number
// of bounces. A flight takes 2*speed/|g|; 2^k flights take s(k) times as long as the first,
// s(k+1) = s(k) * (1 + e^(2^k)), and leave e^(2^k) of the speed, so doubling finds the last bounce in a few iterations
// at every restitution. A sphere that would bounce 2^32 times more is at rest: for e < 1 that is Zeno's time,
// 2*speed/(|g|(1-e)), and for e = 1 it is lower than any float can show.
ANY_REAL FN Rebound OF_REAL rebound(Real time, Real speed, MotionParams m) {
  Rebound OF_REAL last = {time, speed};
  if (m.gravity == 0.0f) return last;
  Real zero = widened(0.0f, time);
  Real one = widened(1.0f, time);
  Real flight = times(speed, constant(m.seconds_per_speed, time));
  if (!below(time, times(flight, constant(m.zeno_flights, time)))) {
    last.time = zero;
    last.speed = zero;
    return last;
  }
  for (uint turn = 0u; turn < 64u && !below(last.time, flight); ++turn) {
    Real flights = flight;
    Real decay = widened(m.restitution, time);
    for (uint k = 0u; k < 32u; ++k) {
      Real longer = times(flights, plus(one, decay));
      if (below(last.time, longer)) break;
      flights = longer;
      decay = times(decay, decay);
    }
    last.time = minus(last.time, flights);
    last.speed = times(last.speed, decay);
    flight = times(last.speed, constant(m.seconds_per_speed, time));
  }
  return last;
}

// Returns position and velocity of a sphere that left the plane `since` ago.
ANY_REAL FN Moving OF_REAL risen(Moving OF_REAL sphere, Rebound OF_REAL since, MotionParams m) {
  Real zero = widened(0.0f, sphere.y);
  Real slowed = times(widened(m.gravity, sphere.y), since.time);
  Real mean = plus(since.speed, times(slowed, widened(0.5f, sphere.y)));
  Real height = times(since.time, mean);
  if (below(height, zero)) height = zero;
  sphere.y = snapped(plus(ground(sphere.radius, m.plane, sphere.y), height));
  sphere.vy = snapped(plus(since.speed, slowed));
  return sphere;
}

// Makes a step with the quadratic time of impact and every bounce within the step.
ANY_REAL FN Moving OF_REAL move_impact(Moving OF_REAL from, MotionParams m) {
  Moving OF_REAL next = glide(from, m);
  if (!below_plane(next.y, from.radius, m.plane)) return next;
  Real zero = widened(0.0f, from.y);
  Real height = minus(from.y, ground(from.radius, m.plane, from.y));
  if (below(height, zero)) height = zero;
  Fall OF_REAL end = fall(height, from.vy, m);
  Real left = minus(widened(m.dt, from.y), end.time);
  if (below(left, zero)) left = zero;
  return risen(next, rebound(left, times(end.speed, widened(m.restitution, from.y)), m), m);
}

// Makes a step with the time of impact on a straight path and one bounce. A sphere that still ends below the plane
// comes to rest.
ANY_REAL FN Moving OF_REAL move_impact_linear(Moving OF_REAL from, MotionParams m) {
  Moving OF_REAL next = glide(from, m);
  if (!below_plane(next.y, from.radius, m.plane)) return next;
  Real zero = widened(0.0f, from.y);
  Real dt = widened(m.dt, from.y);
  Real level = ground(from.radius, m.plane, from.y);
  Real height = minus(from.y, level);
  if (below(height, zero)) height = zero;
  Real time = times(dt, quotient(height, plus(height, minus(level, next.y))));
  Real slower = times(widened(m.gravity, from.y), time);
  Rebound OF_REAL last = {minus(dt, time), times(negated(plus(from.vy, slower)), widened(m.restitution, from.y))};
  next = risen(next, last, m);
  if (below(level, next.y)) return next;
  next.vy = zero;
  return next;
}

#endif
