// SPDX-License-Identifier: MIT
// Continuous collision detection: whether two spheres touch at any time within the next dt, on the paths that the
// scene's motion takes from the float32 numbers nearest to its state:
// - impact and anchored: flights and bounces on the plane, then rest. The first BOUNCES_FOLLOWED bounces are followed
//   one by one. After them a sphere counts as anywhere between the plane and the height of its last flight, which no
//   later bounce exceeds.
// - impact_linear: it is on the plane at the time that the method finds, flies on and rests where it comes down again.
// - From below the plane, a sphere of impact and impact_linear flies on where the step takes it above, and else is put
//   onto the plane. One of anchored is on the plane where its flight is below, until one from the plane would end.
// - euler, symplectic, paper, paper_clamp: no bounce within a step, since a step that ends below the plane begins with
//   the velocity reversed. What paper_clamp then puts on the plane is there at the end of the step, not before.
// - leapfrog: straight, by the momentum with the impulses of contacts, walls and gravity that begin the step.
// The host tells the velocity with which a path begins and, in w, how it goes on (swept_paths.h). Seen from a frame
// that starts at rest and falls as spheres do, paths are straight between bounces; resting spheres rise in it.
// At its start the test is exact; the rest is float64 with margins on the side of a contact: none is missed, and the
// bits of every operation are fixed, so that every backend finds the same pairs.
#ifndef SPHEREPAIR_SWEPT_H
#define SPHEREPAIR_SWEPT_H

#include "common/shared/exact.h"
#include "common/shared/layout.h"
#include "common/shared/wide.h"

const float PATH_STRAIGHT = 0.0f;    // euler, symplectic, paper, paper_clamp, leapfrog
const float PATH_ONE_BOUNCE = 1.0f;  // impact_linear
const float PATH_BOUNCES = 2.0f;     // impact, anchored; below 0: from below the plane, upwards at -w m/s
const float PATH_FLIGHT = 3.0f;      // impact, impact_linear or anchored, in a step without a bounce
const uint BOUNCES_FOLLOWED = 16u;
const uint DEEPEST_HALVING = 24u;

// Part of a path, in seconds from the start of the step and metres along y in the frame. At t seconds from its begin
// the sphere is at y + v*t + lift*t*t/2, or up to `wander` above or below that.
struct PathPart {
  double begin, end, y, v, lift, wander;
  double rounding;  // bound for all places on the path, in metres
  double speed;     // after the bounce that ends the part, upwards
  uint bounces;     // before this part
  bool falls;       // reaches the plane within the step; else this is the whole path
  bool lifted;      // was moved onto the plane at the start
};

FN double size_of(double x) { return x < bits_double(0u, 0u) ? -x : x; }
FN double gravity_of(MotionParams m) { return size_of(exact_double(m.gravity)); }  // downwards
FN double half_of(double x) { return times(x, double(0.5f)); }

// Bounds the rounding of places on a path: 2^-44 of the sum of the sizes of all their terms, |x| + |y| + |z| + radius +
// |plane| + dt*(|vx| + |vy| + |vz| + |g|*dt). Errors, as shares of that sum:
// - A place is a sum of few terms, within 2^-50.
// - The height above the plane is within 2^-52. If it is h off and the speed of impact is s, the impact comes h/s later
//   and each flight lasts 2h/s longer: after k bounces the sphere is off by (3 + 2k)*h at most, 2^-46.8 for 16.
// - Square roots and quotients are within 2 ulp (wide.h), so times are within 2^-49.5 of dt. Speeds s before and after
//   a bounce bring that to 2^-48.5, since s*dt is below the sum.
// Together they are below 2^-46; 2^-44 is taken.
FN double rounding_of_path(vec4 s, vec4 velocity, MotionParams m) {
  double seconds = exact_double(m.dt);
  EXACT double speeds = (size_of(exact_double(velocity.x)) + size_of(exact_double(velocity.y))) +
                        (size_of(exact_double(velocity.z)) + seconds * gravity_of(m));
  EXACT double places = (size_of(exact_double(s.x)) + size_of(exact_double(s.y))) +
                        (size_of(exact_double(s.z)) + (exact_double(s.w) + size_of(exact_double(m.plane))));
  EXACT double rounding = (places + seconds * speeds) * bits_double(0x3D300000u, 0u);  // 2^-44
  return rounding;
}

// Returns the part of a sphere that comes from below the plane at `speed` and is now at this height: it is between the
// plane and where it would fly without gravity.
FN PathPart part_from_below(PathPart part, double height, double speed, MotionParams m) {
  double zero = bits_double(0u, 0u);
  double gravity = gravity_of(m);
  EXACT double highest = height + (part.v > zero ? part.v : zero) * part.end;
  part.wander = half_of(highest);
  part.y = plus(minus(part.y, height), part.wander);
  double time = gravity > zero ? times(half_of(constant(m.seconds_per_speed, zero)), plus(part.v, speed)) : part.end;
  if (time < part.end) part.end = time > zero ? time : zero;
  part.v = zero;
  part.lift = gravity;
  part.speed = times(speed, exact_double(m.restitution));
  part.falls = true;
  return part;
}

FN PathPart first_part(vec4 s, vec4 velocity, MotionParams m) {
  double zero = bits_double(0u, 0u);
  double seconds = exact_double(m.dt);
  double y = exact_double(s.y);
  double v = exact_double(velocity.y);
  double rounding = rounding_of_path(s, velocity, m);
  PathPart part = {zero, seconds, y, v, zero, zero, rounding, zero, 0u, false, false};
  if (velocity.w == PATH_STRAIGHT || velocity.w == PATH_FLIGHT) return part;
  v = snapped(v);
  double gravity = gravity_of(m);
  EXACT double height = (y - exact_double(s.w)) - exact_double(m.plane);
  part.lifted = height < zero;
  if (part.lifted) {
    part.y = plus(y, -height);
    height = zero;
  }
  if (velocity.w < PATH_STRAIGHT) return part_from_below(part, height, -exact_double(velocity.w), m);
  EXACT double depth = seconds * (half_of(seconds * gravity) - v) - height;  // at the end, without the plane
  part.falls = velocity.w == PATH_ONE_BOUNCE || !(depth < -rounding);
  if (!part.falls) return part;
  double time = zero;
  if (velocity.w == PATH_ONE_BOUNCE) {
    if (!part.lifted) time = depth > zero ? times(seconds, quotient(height, plus(height, depth))) : seconds;
    EXACT double impact = gravity * time - v;
    EXACT double earlier = v - half_of(gravity * (seconds - time));  // arrives at that time
    part.speed = impact;
    part.v = earlier;
  } else {
    EXACT double square = v * v + (gravity * (height + height));
    part.speed = square_root(square);
    if (!(v < zero)) time = times(half_of(constant(m.seconds_per_speed, v)), plus(v, part.speed));
    if (v < zero && height > zero) time = quotient(plus(height, height), minus(part.speed, v));
  }
  part.speed = part.speed > zero ? times(part.speed, exact_double(m.restitution)) : zero;
  if (time < seconds) part.end = time;
  return part;
}

FN PathPart next_part(PathPart last, vec4 s, vec4 velocity, MotionParams m) {
  double zero = bits_double(0u, 0u);
  double seconds = exact_double(m.dt);
  double gravity = gravity_of(m);
  double flight = times(last.speed, constant(m.seconds_per_speed, zero));
  EXACT double risen = gravity * last.end;  // speed of the plane in the frame
  EXACT double level = (exact_double(m.plane) + exact_double(s.w)) + half_of(risen * last.end);
  PathPart part = last;
  part.begin = last.end;
  part.end = seconds;
  part.y = level;
  part.lift = zero;
  part.wander = zero;
  part.bounces = last.bounces + 1u;
  if (part.bounces <= BOUNCES_FOLLOWED && last.speed > zero) {
    part.v = plus(last.speed, risen);
    double end = plus(last.end, flight);
    if (gravity > zero && end < seconds) part.end = end;
    part.speed = velocity.w == PATH_ONE_BOUNCE ? zero : times(last.speed, exact_double(m.restitution));
    return part;
  }
  EXACT double half_height = (flight * last.speed) * double(0.125f);  // of the flight, whose height is flight*speed/4
  part.y = plus(level, half_height);
  part.wander = half_height;
  part.v = risen;
  part.lift = gravity;
  return part;
}

// Whether two spheres at a distance of (x, y, z) come within `reach` of each other on a straight path, with a margin of
// 2^-44 of the squares compared. from_start: also if they are nearest at the start.
FN bool near_on_line(double x, double y, double z, double vx, double vy, double vz, double reach, double seconds,
                     bool from_start) {
  double zero = bits_double(0u, 0u);
  double margin = bits_double(0x3D300000u, 0u);  // 2^-44
  EXACT double q = reach * reach;
  EXACT double s = (x * x + y * y) + z * z;
  EXACT double speed = (vx * vx + vy * vy) + vz * vz;  // squared
  EXACT double parting = (x * vx + y * vy) + z * vz;   // half of d(distance^2)/dt at the start
  EXACT double parting_error = margin * (s * speed);
  EXACT double parting_square = parting * parting;
  EXACT double gap = (s - q) - margin * (s + q);
  if (from_start && !(gap > zero)) return true;
  if (!(speed > zero)) return false;
  if (parting > zero && parting_square > parting_error) return false;  // nearest at the start
  EXACT double slowing = speed * seconds;
  if (-parting >= slowing) {  // nearest at the end
    EXACT double end_x = x + vx * seconds;
    EXACT double end_y = y + vy * seconds;
    EXACT double end_z = z + vz * seconds;
    EXACT double end = (end_x * end_x + end_y * end_y) + end_z * end_z;
    EXACT double least = q + margin * ((s + q) + slowing * seconds);
    return !(end > least);
  }
  EXACT double left = gap * speed;
  EXACT double right = parting_square + parting_error;
  return parting < zero ? !(left > right) : !(gap > zero);
}

// Tests one part of each path, from `begin` to `end`. If one sphere rests and the other flies, chords replace the
// parabola, which is within lift*t*t/8 of them. A chord that may touch is halved until lift*t*t/8 is below 2^-24 of the
// reach. Halvings are few, since no quartic stays so near to 0 for long.
FN bool touch_on_parts(vec4 a, vec4 va, PathPart pa, vec4 b, vec4 vb, PathPart pb, double begin, double end,
                       double rounding) {
  double zero = bits_double(0u, 0u);
  double fine = bits_double(0x3E700000u, 0u);  // 2^-24
  EXACT double ta = begin - pa.begin;
  EXACT double tb = begin - pb.begin;
  EXACT double vx = exact_double(va.x) - exact_double(vb.x);
  EXACT double vz = exact_double(va.z) - exact_double(vb.z);
  EXACT double x = (exact_double(a.x) - exact_double(b.x)) + vx * begin;
  EXACT double z = (exact_double(a.z) - exact_double(b.z)) + vz * begin;
  EXACT double y = (pa.y + (pa.v + half_of(pa.lift * ta)) * ta) - (pb.y + (pb.v + half_of(pb.lift * tb)) * tb);
  EXACT double vy = (pa.v + pa.lift * ta) - (pb.v + pb.lift * tb);
  EXACT double lift = pa.lift - pb.lift;
  EXACT double wander = pa.wander + pb.wander;
  EXACT double reach = (exact_double(a.w) + exact_double(b.w)) + (wander + rounding);
  bool anywhere = wander > zero || rounding > times(fine, reach) || pa.lifted || pb.lifted;
  double width = minus(end, begin);
  double t = zero;
  uint halvings = 0u;
  uint chord = 0u;  // number of the chord, out of 2^halvings
  for (;;) {
    EXACT double sagitta = (size_of(lift) * width) * (width * double(0.125f));
    EXACT double chord_x = x + vx * t;
    EXACT double chord_z = z + vz * t;
    EXACT double chord_y = y + (vy + half_of(lift * t)) * t;
    EXACT double chord_vy = vy + lift * (t + half_of(width));
    if (near_on_line(chord_x, chord_y, chord_z, vx, chord_vy, vz, plus(reach, sagitta), width,
                     anywhere || sagitta > zero)) {
      if (!(sagitta > times(fine, reach)) || halvings == DEEPEST_HALVING) return true;
      halvings += 1u;
      chord = chord << 1;
      width = half_of(width);
      continue;
    }
    chord += 1u;
    t = plus(t, width);
    for (; halvings > 0u && (chord & 1u) == 0u; --halvings) {
      chord = chord >> 1;
      width = plus(width, width);
    }
    if (halvings == 0u) return false;
  }
}

FN bool touch_within(vec4 a, vec4 va, vec4 b, vec4 vb, MotionParams m, float scale, float offset) {
  if (decide_pair(a, b, scale, offset).collide) return true;
  PathPart pa = first_part(a, va, m);
  PathPart pb = first_part(b, vb, m);
  double seconds = exact_double(m.dt);
  double begin = bits_double(0u, 0u);
  double rounding = pa.falls || pb.falls ? plus(pa.rounding, pb.rounding) : begin;  // 0: test starts from exact numbers
  for (uint turn = 0u; turn < 2u * BOUNCES_FOLLOWED + 4u; ++turn) {
    double end = pa.end < pb.end ? pa.end : pb.end;
    if (touch_on_parts(a, va, pa, b, vb, pb, begin, end, rounding)) return true;
    if (!(end < seconds)) return false;
    if (!(pa.end > end)) pa = next_part(pa, a, va, m);
    if (!(pb.end > end)) pb = next_part(pb, b, vb, m);
    begin = end;
  }
  return true;
}

#endif
