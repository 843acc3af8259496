// SPDX-License-Identifier: MIT
// The event-driven method `anchored`. A sphere's state is its last bounce (at first, its start) and the number of steps
// since. Its position at any step is one evaluation of the parabola, so nothing is written or rounded between bounces.
// Horizontally the anchor stays at the start.
#ifndef SPHEREPAIR_ANCHOR_H
#define SPHEREPAIR_ANCHOR_H

#include "common/shared/impact.h"

ANY_REAL struct Anchor {
  vec4 start;       // centre at step 0, radius in w
  float vx, vz;     // constant
  Real speed, age;  // upwards at the anchor; seconds from the anchor to step `since`
  uint since;       // with ANCHOR_ON_PLANE once it has bounced
};

// Returns the duration of `steps` steps, in seconds: both halves of the count are exact floats.
ANY_REAL FN Real seconds_of(uint steps, Real kind, MotionParams m) {
  EXACT float high = float(steps >> 16) * 65536.0f;
  return times(plus(widened(high, kind), widened(float(steps & 0xFFFFu), kind)), widened(m.dt, kind));
}

FN bool on_plane(uint since) { return (since & ANCHOR_ON_PLANE) != 0u; }

ANY_REAL FN Real seconds_since(Anchor OF_REAL a, MotionParams m) {
  return plus(seconds_of(m.steps_done - (a.since & ~ANCHOR_ON_PLANE), a.age, m), a.age);
}

// Returns the flight from the anchor to the plane. Without gravity the sphere may never reach it: see `leaves`.
ANY_REAL FN Fall OF_REAL flight_of(Anchor OF_REAL a, MotionParams m) {
  Real zero = widened(0.0f, a.age);
  if (on_plane(a.since)) {
    Fall OF_REAL whole = {times(a.speed, constant(m.seconds_per_speed, a.age)), a.speed};
    return whole;
  }
  Real height = minus(widened(a.start.y, a.age), ground(a.start.w, m.plane, a.age));
  if (below(height, zero)) height = zero;
  return fall(height, a.speed, m);
}

// Whether the sphere rests, or rises for ever.
ANY_REAL FN bool leaves(Anchor OF_REAL a, MotionParams m) {
  Real zero = widened(0.0f, a.age);
  if (on_plane(a.since) && !below(zero, a.speed)) return true;
  return m.gravity == 0.0f && !below(a.speed, zero);
}

// Returns the first step after which the sphere may have reached the plane: float32 with a margin for its rounding.
ANY_REAL FN uint next_event_step(Anchor OF_REAL a, MotionParams m) {
  if (leaves(a, m)) return NO_EVENT;
  float seconds = nearest(minus(flight_of(a, m).time, a.age));
  float steps = times(times(seconds, m.steps_per_second), bits_float(0x3F7FFFF0u));  // 1 - 2^-20
  return (a.since & ~ANCHOR_ON_PLANE) + 1u + uint(smaller(larger(steps, 0.0f), 1073741824.0f));
}

// Returns the anchor after the bounces of the current step, or the same one if there was none.
ANY_REAL FN Anchor OF_REAL anchor_anew(Anchor OF_REAL a, MotionParams m) {
  Fall OF_REAL end = flight_of(a, m);
  Real left = minus(seconds_since(a, m), end.time);
  if (below(left, widened(0.0f, left))) return a;
  Rebound OF_REAL last = rebound(left, times(end.speed, widened(m.restitution, left)), m);
  a.speed = last.speed;
  a.age = last.time;
  a.since = m.steps_done | ANCHOR_ON_PLANE;
  return a;
}

// Returns position and velocity at the current step.
ANY_REAL FN Moving OF_REAL evaluate_sphere(Anchor OF_REAL a, MotionParams m) {
  Real time = seconds_since(a, m);
  Real total = seconds_of(m.steps_done, a.age, m);
  Real level = ground(a.start.w, m.plane, a.age);
  Real slowed = times(widened(m.gravity, a.age), time);
  Moving OF_REAL now = {widened(a.start.x, a.age),
                        widened(a.start.y, a.age),
                        widened(a.start.z, a.age),
                        widened(a.vx, a.age),
                        plus(a.speed, slowed),
                        widened(a.vz, a.age),
                        a.start.w};
  now.x = drift(now.x, now.vx, total);
  now.z = drift(now.z, now.vz, total);
  if (on_plane(a.since)) now.y = level;
  if (on_plane(a.since) && !below(widened(0.0f, a.age), a.speed)) {
    now.vy = widened(0.0f, a.age);
  } else {
    now.y = plus(now.y, times(time, plus(a.speed, times(slowed, widened(0.5f, a.age)))));
  }
  if (below(now.y, level)) now.y = level;
  now.y = snapped(now.y);
  now.vx = snapped(now.vx);
  now.vy = snapped(now.vy);
  now.vz = snapped(now.vz);
  return now;
}

#endif
