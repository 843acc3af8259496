// SPDX-License-Identifier: MIT
// Whether units of length and momentum are fine enough for a contact of the fastest sphere: for its depth, and for the
// momentum that one step of it changes.
#pragma once

#include <string>

#include "common/scene/contact/contact_law.h"

namespace spherepair {

// The lightest sphere at the highest speed against the largest at rest: of all contacts of that speed the one with the
// fewest units.
struct FastestContact {
  const ContactOptions& contact;  // with its units
  Radii radii;
  double speed, dt;  // m/s, s
};

// Says which stiffness or time step has units enough for 0.1 % of the speed; empty where the chosen ones do.
std::string why_unresolved(const FastestContact& fastest);

}  // namespace spherepair
