// SPDX-License-Identifier: MIT
// Contacts of spheres that push each other. The state is in 64-bit integers (fixed.h). A leapfrog step adds the
// impulses of all contacts and of gravity to each momentum, then moves the sphere by the momentum, rounded once. Every
// impulse is rounded to an integer before it is added, so sums need no order. Every operation is odd, so each of two
// spheres gets exactly the negative of the other's impulse.
#ifndef SPHEREPAIR_CONTACT_H
#define SPHEREPAIR_CONTACT_H

#include "common/shared/contact/body.h"
#include "common/shared/contact/contact_quotient.h"
#include "common/shared/contact/gap.h"

struct Push {
  int64_t x, y, z;  // impulse
  uint fault;       // FAULT_*, FAULTS: none
};
struct FloatPush {  // before it is rounded
  float x, y, z;
  uint fault;
};

FN float cubed(float radius) {
  EXACT float square = radius * radius;
  EXACT float cube = square * radius;
  return cube;
}

// Returns how many units of length a unit of momentum moves this sphere in a step; its mass decides.
FN float mobility_of(float radius, ContactParams c) { return corrected_quotient(c.mobility, cubed(radius)); }

// Returns the impulse over the gap's length: times the gap's components in unit_length it is the impulse. closing: the
// relative speed, in units a step, dotted with these components. reduced_cube: of the radii, for the reduced mass.
// Momenta are half a step older than positions. The damper uses the speed in the middle of the step, after half of the
// impulse: hence the divisor.
FN float push_per_length(Gap g, float closing, float reduced_cube, ContactParams c) {
  if (c.law == CONTACT_QUARTIC) {
    EXACT float depth = float_of(int64_t(g.reach * g.reach - g.square)) * power_of_two(-58);
    EXACT float cube = (g.scale * g.scale) * g.scale;
    EXACT float push = (c.impulse * depth) * cube;
    return push;
  }
  if (g.square == 0ul) return 0.0f;
  Overlap o = overlap_of(g);
  EXACT float overlap = o.overlap * g.scale;
  EXACT float elastic = c.impulse * overlap;
  if (c.law == CONTACT_HERTZ) {
    EXACT float push = (elastic * same_root(overlap)) * o.inverse_distance;
    return push;
  }
  if (c.damping == 0.0f) {
    EXACT float push = elastic * o.inverse_distance;
    return push;
  }
  EXACT float speed = closing * o.inverse_distance;
  float root = corrected_root(reduced_cube);
  EXACT float undamped = elastic + (c.damping * root) * speed;
  EXACT float halved = (c.damping * c.mobility) * 0.5f;
  EXACT float slower = corrected_quotient(halved, root) + 1.0f;
  EXACT float push = larger(corrected_quotient(undamped, slower), 0.0f) * o.inverse_distance;
  return push;
}

FN float speed_of(int64_t momentum, float mobility) {
  EXACT float speed = float_of(momentum) * mobility;
  return speed;
}
// Whether the sphere stays in place: with drag it does if a step would move it by less than 2^-30 of the smallest
// radius. Its damper then gives nothing. That is about half a unit of its gaps (gap.h): too little to change an
// impulse.
FN bool stays(float speed, ContactParams c) {
  EXACT float slowest = c.fastest * power_of_two(-30);
  return c.drag_loss != 0.0f && speed < slowest && speed > -slowest;
}
FN float moving_speed_of(int64_t momentum, float mobility, ContactParams c) {
  float speed = speed_of(momentum, mobility);
  return stays(speed, c) ? 0.0f : speed;
}
FN float closing_speed(Body a, Body b, Gap g, ContactParams c) {
  float ma = mobility_of(a.radius, c);
  float mb = mobility_of(b.radius, c);
  EXACT float x = (moving_speed_of(b.px, mb, c) - moving_speed_of(a.px, ma, c)) * unit_length(g.x);
  EXACT float y = (moving_speed_of(b.py, mb, c) - moving_speed_of(a.py, ma, c)) * unit_length(g.y);
  EXACT float z = (moving_speed_of(b.pz, mb, c) - moving_speed_of(a.pz, ma, c)) * unit_length(g.z);
  EXACT float sum = (x + y) + z;
  return sum;
}

FN float reach_of_pair(Body a, Body b) {
  EXACT float reach = a.radius + b.radius;
  return reach;
}
FN Gap gap_between(Body a, Body b, ContactParams c) {
  Ways way = ways_between(a, b, c);
  return gap_of(way.x, way.y, way.z, reach_of_pair(a, b), c);
}

// Returns the impulse that b gives a; a gives b the negative.
FN FloatPush float_push_of_pair(Body a, Body b, ContactParams c) {
  FloatPush push = {0.0f, 0.0f, 0.0f, FAULTS};
  float reach = reach_of_pair(a, b);
  Gap g = gap_between(a, b, c);
  if (!in_contact(g)) return push;
  if (deeper_than(g, smaller(a.radius, b.radius), reach)) push.fault = FAULT_DEEP;
  float closing = 0.0f;
  float reduced = 0.0f;
  if (c.damping != 0.0f) {
    float first = cubed(a.radius);
    float second = cubed(b.radius);
    EXACT float sum = first + second;
    EXACT float product = larger(first, second) * corrected_quotient(smaller(first, second), sum);
    closing = closing_speed(a, b, g, c);
    reduced = product;
  }
  float per_length = push_per_length(g, closing, reduced, c);
  EXACT float x = per_length * unit_length(g.x);
  EXACT float y = per_length * unit_length(g.y);
  EXACT float z = per_length * unit_length(g.z);
  push.x = x;
  push.y = y;
  push.z = z;
  return push;
}
FN Push rounded_push(FloatPush push) {
  Push rounded = {integer_of(push.x), integer_of(push.y), integer_of(push.z), push.fault};
  return rounded;
}
FN Push push_of_pair(Body a, Body b, ContactParams c) { return rounded_push(float_push_of_pair(a, b, c)); }

// Returns the impulse of a wall at this distance, away from the wall; -1 if the centre is behind it.
FN int64_t push_of_wall(int64_t distance, int64_t outward_momentum, float radius, ContactParams c) {
  if (distance <= 0l) return -1l;
  Gap g = gap_of(distance, 0l, 0l, radius, c);
  if (!in_contact(g)) return 0l;
  float closing = 0.0f;
  if (c.damping != 0.0f) {
    EXACT float speed = -moving_speed_of(outward_momentum, mobility_of(radius, c), c) * unit_length(g.x);
    closing = speed;
  }
  EXACT float push = push_per_length(g, closing, cubed(radius), c) * unit_length(g.x);
  return integer_of(push);
}

// Walls are bits: low x, y, z, high x, y, z. There are none along periodic axes.
FN uint all_walls(ContactParams c) {
  uint axes = 7u - periodic_axes(c);
  return axes | axes << 3;
}

// Returns the walls nearer than the power of two above the radius: most spheres have none.
FN uint walls_near(Body s, ContactParams c) {
  int64_t reach = int64_t(1ul << (uint(c.unit_exponent) + exponent_field(s.radius) - 126u));
  uint near = (s.x - c.low_x < reach ? 1u : 0u) | (s.y - c.low_y < reach ? 2u : 0u) |
              (s.z - c.low_z < reach ? 4u : 0u) | (c.high_x - s.x < reach ? 8u : 0u) |
              (c.high_y - s.y < reach ? 16u : 0u) | (c.high_z - s.z < reach ? 32u : 0u);
  return near & all_walls(c);
}
FN int64_t on_axis(uint axis, int64_t x, int64_t y, int64_t z) { return axis == 0u ? x : (axis == 1u ? y : z); }

// Sums the impulses of near walls. It loops over them so that a GPU's threads run the same code, whichever wall is
// theirs. tests_all: also over the other walls, which changes nothing.
FN Push push_of_walls(Body s, bool tests_all, ContactParams c) {
  Push sum = {0l, 0l, 0l, FAULTS};
  for (uint left = tests_all ? all_walls(c) : walls_near(s, c); left != 0u;) {
    uint wall = highest_bit(left);
    left -= 1u << wall;
    bool is_high = wall >= 3u;
    uint axis = is_high ? wall - 3u : wall;
    int64_t at = on_axis(axis, s.x, s.y, s.z);
    int64_t momentum = on_axis(axis, s.px, s.py, s.pz);
    int64_t low = on_axis(axis, c.low_x, c.low_y, c.low_z);
    int64_t high = on_axis(axis, c.high_x, c.high_y, c.high_z);
    int64_t push = push_of_wall(is_high ? high - at : at - low, is_high ? -momentum : momentum, s.radius, c);
    if (push < 0l) sum.fault = FAULT_DEEP;
    int64_t along = is_high ? -push : push;
    sum.x += axis == 0u ? along : 0l;
    sum.y += axis == 1u ? along : 0l;
    sum.z += axis == 2u ? along : 0l;
  }
  return sum;
}

// Returns speeds in units of length a step.
FN vec4 speeds_of(Body s, float mobility) {
  vec4 speeds = {speed_of(s.px, mobility), speed_of(s.py, mobility), speed_of(s.pz, mobility), 0.0f};
  return speeds;
}

FN bool outside_range(int64_t x) { return x >= MOST_UNITS || x <= -MOST_UNITS; }
FN bool too_fast(float speed, ContactParams c) { return speed > c.fastest || speed < -c.fastest; }

// Returns what stops a sphere from moving at these speeds: a FAULT_*, or FAULTS for nothing.
FN uint fault_of(Body s, vec4 speeds, ContactParams c) {
  if (outside_range(s.x) || outside_range(s.y) || outside_range(s.z)) return FAULT_RANGE;
  return too_fast(speeds.x, c) || too_fast(speeds.y, c) || too_fast(speeds.z, c) ? FAULT_FAST : FAULTS;
}
FN bool any_fault(uint deep, uint fast, uint range) { return (deep & fast & range) != 0xFFFFFFFFu; }

// Returns the sphere after the impulses of spheres, walls and gravity; its position has not moved yet.
FN Body kicked(Body s, Push contacts, Push walls, ContactParams c) {
  EXACT float weight = c.gravity * cubed(s.radius);
  s.px += contacts.x + walls.x;
  s.py += contacts.y + walls.y + integer_of(weight);
  s.pz += contacts.z + walls.z;
  return s;
}
FN Body drifted(Body s, vec4 speeds, float mobility, ContactParams c) {
  s.x += stays(speeds.x, c) ? 0l : scaled(s.px, mobility);
  s.y += stays(speeds.y, c) ? 0l : scaled(s.py, mobility);
  s.z += stays(speeds.z, c) ? 0l : scaled(s.pz, mobility);
  return wrapped(s, c);
}

// Returns the float32 velocity nearest to these speeds.
FN vec4 velocity_of(vec4 speeds, ContactParams c) {
  EXACT float x = speeds.x * c.metres_per_second;
  EXACT float y = speeds.y * c.metres_per_second;
  EXACT float z = speeds.z * c.metres_per_second;
  vec4 velocity = {x, y, z, 0.0f};
  return velocity;
}

#endif
