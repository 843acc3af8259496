// SPDX-License-Identifier: MIT
// Spheres that push each other, moved by the equations in docs/contacts.md: m dv/dt = sum of forces - D m v + m g. In
// extended precision, by Runge-Kutta of fourth order with steps that end where a contact begins or ends. Nothing here
// is taken from the program.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tests/oracle/contact_oracle.h"

namespace spherepair {

using Real = long double;

struct OracleSphere {
  std::array<Real, 3> at, velocity;
  Real radius;
};

// Pushes spheres along an axis, up or down.
struct OracleWall {
  std::size_t axis;
  Real at;
  bool up;
};

struct OracleWorld {
  OracleLaw law = OracleLaw::spring;
  Real stiffness = 0;
  Real damping = 0;  // over the critical value, of every contact
  Real gravity = 0;  // along y, in m/s^2
  Real drag = 0;     // in 1/s
  Real plane = 0;    // the first wall, to which heights are measured
  std::vector<OracleSphere> spheres;
  std::vector<OracleWall> walls = {};
};

Real oracle_mass(Real radius);  // in kg: 1000 kg/m^3

// Moves the world by `seconds`, in steps of at most `longest_step` seconds.
void advance(OracleWorld& world, Real seconds, Real longest_step);

// The columns of --statistics for the current state.
struct OracleStatistics {
  Real kinetic = 0, contact = 0, potential = 0, virial = 0, floor_force = 0, greatest_overlap = 0;
  std::array<Real, 3> momentum = {};
  int contacts = 0, wall_contacts = 0;
};
OracleStatistics statistics_of(const OracleWorld& world);

// The damping over its critical value with which a contact leaves this share of the closing speed, found by bisection
// over simulated contacts; and the duration of such a contact, where one without a damper lasts pi.
struct OracleDamper {
  Real damping, seconds;
};
OracleDamper damper_for(Real restitution);

}  // namespace spherepair
