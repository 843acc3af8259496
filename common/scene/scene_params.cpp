// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "common/scene/scene_params.h"

namespace spherepair {
namespace {

constexpr float largest = std::numeric_limits<float>::max();

// Rounded towards +infinity or -infinity; `value` may exceed the floats.
float round_up(double value) {
  const float nearest = float(value);
  return double(nearest) >= value ? nearest : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}
float round_down(double value) {
  if (value > double(largest)) return largest;
  const float nearest = float(value);
  return double(nearest) <= value ? nearest : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

// Three floats that add up to the double.
vec4 split(double value) {
  const float high = float(value), middle = float(value - double(high));
  return {high, middle, float(value - double(high) - double(middle)), 0};
}

// How many times as long as the first 2^32 flights take, each e times as long as the one before.
double flights_to_rest(double e) {
  double sum = 1, decay = e;
  for (int doubling = 0; doubling < 32; ++doubling, decay *= decay) sum *= 1 + decay;
  return sum;
}

}  // namespace

Params scene_params(const Scene& scene, bool exact) {
  Params p{};
  const double dt = scene.dt, gravity = scene.gravity;
  p.dt = scene.dt;
  p.gravity = scene.gravity;
  p.steps_per_second = float(1 / dt);
  p.gravity_dt = split(gravity * dt);
  p.half_gravity_dt2 = split(0.5 * gravity * dt * dt);
  p.seconds_per_speed = split(gravity == 0 ? 0 : 2 / std::abs(gravity));
  p.zeno_flights = split(flights_to_rest(double(scene.restitution)));
  p.restitution = scene.restitution;
  p.plane = scene.plane;
  p.radius = scene.equal_radii && scene.size() ? scene.positions[0].w : 0.0f;
  const double diameter = 2.0 * double(p.radius);
  const double q = diameter * diameter;  // exact: 24-bit factor
  const double margin = 12 * 0x1p-24, offset = 0x1p-100;
  p.apart_above = exact ? round_up(q * (1 + margin) + offset) : float(q);
  p.collide_below = exact ? round_down(q * (1 - margin) - offset) : float(q);
  p.filter_scale = exact ? bits_float(0x3F80000Cu) : 1.0f;  // 1 + 24 * 2^-24
  p.filter_offset = exact ? 0x1p-100f : 0.0f;
  p.defer_undecided = exact;
  return p;
}

}  // namespace spherepair
