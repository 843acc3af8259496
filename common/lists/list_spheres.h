// SPDX-License-Identifier: MIT
// A list's problem as one search for colliding spheres: all systems beside each other, with the images of points that
// the reach of others comes to. Each sphere is larger than its share of the reach by all that is rounded on the way, so
// that every pair of the list collides here; displacement.h tells them from the few others.
#pragma once

#include "common/lists/lattice.h"
#include "common/shared/layout.h"

namespace spherepair {

struct PointImage {
  uint32_t point, system;
  Shift shift;  // from the point inside the box
};

struct ListSpheres {
  std::vector<vec4> spheres;              // those that look, in order (queries, or points), then the images
  std::vector<PointImage> images;         // of spheres[looking], spheres[looking + 1] ...
  std::vector<uint32_t> systems;          // of those that look
  std::vector<Shift> first_cells, cells;  // of those that look and of points: x = inside + cell H
  std::vector<Lattice> lattices;          // one a system
  uint64_t looking() const { return systems.size(); }
};

// Throws ListError for a flat box, for points too far outside of one, and for more images than 2^27.
ListSpheres list_spheres(const ListProblem& problem);

}  // namespace spherepair
