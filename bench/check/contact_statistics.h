// SPDX-License-Identifier: MIT
// Energies, momentum and contacts of a scene at one step. Computed from the 64-bit state on the host, in order, so that
// the same state gives the same numbers on every backend.
#pragma once

#include <array>
#include <span>
#include <string>

#include "common/scene/pair_set.h"
#include "common/scene/scene.h"

namespace spherepair {

struct ContactStatistics {
  uint64_t step = 0;
  double seconds = 0;  // step * dt

  // Joules. kinetic: of the momenta at this step; the state's are half a step earlier, so half of the step's drag and
  // impulses are added. potential: of the heights of the centres above the plane.
  double kinetic = 0, contact = 0, potential = 0;
  std::array<double, 3> momentum = {};  // kg m/s, at this step, too
  double greatest_overlap = 0;          // metres, of spheres and walls
  uint64_t contacts = 0, wall_contacts = 0;

  // Joules: sum of force times distance of the centres over the contacts of spheres. The pressure of a gas in a box is
  // (2 kinetic + virial) / (3 volume), where the volume is the part of the box that centres can reach.
  double virial = 0;
  double floor_force = 0;  // newtons, of all spheres on the plane

  double energy() const { return kinetic + contact + potential; }
};

// wide: the state's words; pairs: the colliding pairs of these positions, in the same order each time.
ContactStatistics contact_statistics(const Scene& scene, const std::vector<uint>& wide, std::span<const Pair> pairs,
                                     uint64_t step);

// Lines of a table: columns separated by commas, their names with units, numbers with all their digits.
std::string statistics_heading();
std::string statistics_row(const ContactStatistics& row);

}  // namespace spherepair
