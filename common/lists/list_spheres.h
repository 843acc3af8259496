// SPDX-License-Identifier: MIT
// A list's problem as one search for colliding spheres: all systems beside each other, with the images of points that
// the reach of others comes to. Each sphere is larger than its share of the reach by all that is rounded on the way, so
// that every pair of the list collides here; displacement.h tells them from the few others.
#pragma once

#include "common/lists/list_systems.h"
#include "common/shared/layout.h"

namespace spherepair {

struct PointImage {
  uint32_t point, system;
  Shift shift;  // from the point inside the box
};

struct ListSpheres {
  explicit ListSpheres(const ListProblem& problem) : looking(problem.firsts().size()), systems(problem.firsts()) {}

  uint64_t looking;                // spheres that look, in order (queries, or points); behind them are the images
  std::vector<vec4> spheres = {};  // of both
  std::vector<PointImage> images = {};
  PointSystems systems;                // of those that look
  PointCells first_cells, cells;       // of those that look and of points
  std::vector<Lattice> lattices = {};  // one a system
};

// Throws ListError for a flat box, for points too far outside of one, and for more images than 2^27.
ListSpheres list_spheres(const ListProblem& problem);

}  // namespace spherepair
