// SPDX-License-Identifier: MIT
#include "tests/oracle/contact_oracle.h"

#include <cmath>
#include <numbers>

namespace spherepair {
namespace {

constexpr int steps_a_contact = 20'000;

long double reach_of(const OracleContact& c) { return c.first_radius + c.second_radius; }

long double reduced_mass(const OracleContact& c) {
  return std::isinf(c.second_mass) ? c.first_mass : c.first_mass * c.second_mass / (c.first_mass + c.second_mass);
}

// Without the damper, at this overlap.
long double force(const OracleContact& c, long double overlap) {
  if (c.law == OracleLaw::spring) return c.stiffness * overlap;
  if (c.law == OracleLaw::hertz) return c.stiffness * std::pow(overlap, 1.5L);
  const long double reach = reach_of(c), distance = reach - overlap;
  return c.stiffness * (reach * reach - distance * distance) * distance;
}

// The time in which the force would stop the spheres if it rose in a line to that at the deepest overlap.
long double scale_of_time(const OracleContact& c, long double speed) {
  long double deepest = 0, energy = 0;
  const long double wanted = reduced_mass(c) * speed * speed / 2, slice = 1e-5L * reach_of(c);
  while (energy < wanted) energy += force(c, deepest + slice / 2) * slice, deepest += slice;
  return std::numbers::pi_v<long double> * deepest / speed;
}

}  // namespace

long double shallow_seconds(const OracleContact& c) {
  const long double step = 1e-9L * reach_of(c), slope = force(c, step) / step;
  return std::numbers::pi_v<long double> * std::sqrt(reduced_mass(c) / slope);
}

long double speed_left(const OracleContact& c, long double closing_speed) {
  const long double mass = reduced_mass(c), h = scale_of_time(c, closing_speed) / steps_a_contact;
  const auto slows = [&](long double overlap, long double speed) {
    return (force(c, overlap > 0 ? overlap : 0) + c.damping * speed) / mass;
  };
  long double overlap = 0, speed = closing_speed;
  while (overlap >= 0 && (speed > 0 || slows(overlap, speed) > 0)) {
    const long double v1 = speed, a1 = -slows(overlap, v1);
    const long double v2 = speed + h / 2 * a1, a2 = -slows(overlap + h / 2 * v1, v2);
    const long double v3 = speed + h / 2 * a2, a3 = -slows(overlap + h / 2 * v2, v3);
    const long double v4 = speed + h * a3, a4 = -slows(overlap + h * v3, v4);
    overlap += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    speed += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return -speed / closing_speed;
}

}  // namespace spherepair
