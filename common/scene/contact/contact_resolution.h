// SPDX-License-Identifier: MIT
// Checks whether units of length and momentum resolve a contact of the fastest sphere: its depth, and the momentum that
// one step of it changes.
#pragma once

#include <string>

#include "common/scene/contact/contact_law.h"

namespace spherepair {

// The lightest sphere at the highest speed against the largest at rest. Of all contacts at that speed, this one has the
// fewest units.
struct FastestContact {
  const ContactOptions& contact;  // with its units
  Radii radii;
  double speed, dt;  // m/s, s
};

// Says which stiffness or time step gives units enough for 0.1 % of the speed; empty if the chosen ones do.
std::string why_unresolved(const FastestContact& fastest);

}  // namespace spherepair
