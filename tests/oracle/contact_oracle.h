// SPDX-License-Identifier: MIT
// Two spheres that collide, from the equations in docs/contacts.md, in extended precision and far finer steps. Nothing
// here is taken from the program.
#pragma once

namespace spherepair {

enum class OracleLaw { spring, quartic, hertz };

// kg, and SI units throughout. A mass of infinity is a wall.
struct OracleContact {
  OracleLaw law;
  long double stiffness;
  long double first_radius, second_radius;
  long double first_mass, second_mass;
  long double damping = 0;  // of spring: kg/s
};

// Half the period of shallow contacts, from the force's slope where the spheres touch. Not for hertz, whose slope there
// is 0.
long double shallow_seconds(const OracleContact& contact);

// The share of the closing speed that is left when the force, which never attracts, has become 0. By Runge-Kutta of
// fourth order.
long double speed_left(const OracleContact& contact, long double closing_speed);

}  // namespace spherepair
