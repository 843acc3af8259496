// SPDX-License-Identifier: MIT
// Contacts of spheres that push each other: the law of the force and its parameters.
#pragma once

#include <array>
#include <string>

#include "common/shared/layout.h"

namespace spherepair {

// The force along the line of centres at overlap o, reach R (sum of radii) and distance d. It never attracts.
enum class ContactLaw : uint {
  none,     // spheres pass through each other
  spring,   // k * o, with a damper where the restitution is below 1
  quartic,  // k * (R^2 - d^2) * d, elastic: neither root nor division
  hertz     // k * o^1.5, elastic
};
const char* contact_name(ContactLaw law);
ContactLaw contact_from_name(const std::string& name);  // throws std::invalid_argument with the known names

// A box along the axes: opposite corners, in metres, and the axes along which it repeats, as bits x, y, z.
struct WallBox {
  std::array<float, 3> low, high;
  uint periodic = 0;
};

std::string axes_text(uint axes);  // of the bits x, y, z, such as xz

constexpr float water = 1000;  // kg/m^3

// A scene's contacts. Units are powers of two, chosen once for a run: 2^-unit_exponent m for positions,
// 2^-momentum_exponent kg m/s for momenta.
struct ContactOptions {
  ContactLaw law = ContactLaw::none;
  float stiffness = 0;           // k * 1000 / density, in N/m, N/m^3 or N/m^1.5: of spheres of water that move alike
  float density = water;         // kg/m^3
  float drag = 0;                // of a fluid at rest: alone, a speed falls to 1/e in 1/drag seconds
  bool sleeping = true;          // with drag, steps skip spheres at rest; the same bits
  bool tests_all_walls = false;  // also for spheres away from walls, for measuring; the same bits
  bool walls = false;            // a closed box: four sides and a lid, the plane is its floor
  vec4 low = {}, high = {};      // its corners; the floor is the plane, or low.y if y is open
  uint periodic = 0;             // bits x, y, z: the box repeats along these axes, which then have no walls
  int unit_exponent = 0, momentum_exponent = 0;
  float skin = 0;  // around spheres, in radii: see skin_of
};

}  // namespace spherepair
