// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "common/scene/scene_params.h"

namespace spherepair {
namespace {

constexpr float largest = std::numeric_limits<float>::max();

// Round towards +infinity or -infinity; `value` may exceed the floats.
float round_up(double value) {
  const float nearest = float(value);
  return double(nearest) >= value ? nearest : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}
float round_down(double value) {
  if (value > double(largest)) return largest;
  const float nearest = float(value);
  return double(nearest) <= value ? nearest : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

// Returns three floats that add up to the double.
vec4 split(double value) {
  const float high = float(value), middle = float(value - double(high));
  return {high, middle, float(value - double(high) - double(middle)), 0};
}

// Returns the time of the first 2^32 flights over the first one's, if each takes e times as long as the previous one.
double flights_to_rest(double e) {
  double sum = 1, decay = e;
  for (int doubling = 0; doubling < 32; ++doubling, decay *= decay) sum *= 1 + decay;
  return sum;
}

}  // namespace

MotionParams motion_params(const Scene& scene) {
  const double dt = scene.dt, gravity = scene.gravity;
  return {.gravity_dt = split(gravity * dt),
          .half_gravity_dt2 = split(0.5 * gravity * dt * dt),
          .seconds_per_speed = split(gravity == 0 ? 0 : 2 / std::abs(gravity)),
          .zeno_flights = split(flights_to_rest(double(scene.restitution))),
          .dt = scene.dt,
          .gravity = scene.gravity,
          .steps_per_second = float(1 / dt),
          .restitution = scene.restitution,
          .plane = scene.plane,
          .steps_done = 0,
          .whole_state = 0,
          .clear_results = 0};
}

float common_radius(const Scene& scene) { return scene.equal_radii && scene.size() ? scene.positions[0].w : 0.0f; }

SearchParams search_params(const Scene& scene, bool exact) {
  const double diameter = 2.0 * double(common_radius(scene));
  const double q = diameter * diameter;  // exact: 24-bit factor
  const double margin = 12 * 0x1p-24, offset = 0x1p-100;
  return {.apart_above = exact ? round_up(q * (1 + margin) + offset) : float(q),
          .collide_below = exact ? round_down(q * (1 - margin) - offset) : float(q),
          .filter_scale = exact ? bits_float(0x3F80000Cu) : 1.0f,  // 1 + 24 * 2^-24
          .filter_offset = exact ? 0x1p-100f : 0.0f,
          .defer_undecided = exact,
          .columns_per_group = 0,
          .pair_capacity = 0,
          .deferred_capacity = 0,
          .near_pairs = 0,
          .chunk = 0,
          .tiles_per_group = 0};
}

}  // namespace spherepair
