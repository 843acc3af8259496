// SPDX-License-Identifier: MIT
// Plans dense cells: one table for all spheres, or for the light of images one table a level of radii.
#pragma once

#include <bit>

#include "common/plan/grid_plan.h"

namespace spherepair {

constexpr double huge_radius = 0x1p100;    // above it cells would overflow float32: one cell holds everything
constexpr double smallest_side = 0x1p-90;  // far above the error from flushed denormals

struct Extent {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  float smallest = 0, largest = 0;  // radius, metres

  double length(int axis) const { return high[axis] - low[axis]; }
};
Extent extent_of(const std::vector<vec4>& spheres);  // of the finite numbers

// Bound on the rounding error of a coordinate, in cells, on an axis of so many cells: 12 units in the last place.
inline double coordinate_margin(double cells) { return cells * 12 * 0x1p-24; }

inline uint octave(float radius) { return std::bit_cast<uint>(radius) >> 23; }
std::vector<uint> octaves_of(const std::vector<vec4>& spheres);  // of the radii, each once, ascending

// n: the number of spheres, which limits the number of cells.
GridPlan dense_plan(const Extent& extent, uint64_t n);

// Returns the dense plan if no radius is more than twice another. Otherwise a plan of several levels: the cells of the
// lowest are as small as their number and the smallest radius allow, but at least twice as long as any radius in their
// level. Each level above doubles both the radius and the cell.
GridPlan light_plan(const GridPlan& dense, const Extent& extent, const std::vector<uint>& octaves, uint64_t n);

}  // namespace spherepair
