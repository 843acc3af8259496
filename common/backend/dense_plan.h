// SPDX-License-Identifier: MIT
// Dense cells: one table for all spheres, or for the light of images a table for each level of radii.
#pragma once

#include <bit>

#include "common/backend/grid_plan.h"

namespace spherepair {

constexpr double huge_radius = 0x1p100;    // above, cells would overflow float32: one cell holds everything
constexpr double smallest_side = 0x1p-90;  // far above what flushed denormals can move

struct Extent {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  float smallest = 0, largest = 0;  // radius

  double length(int axis) const { return high[axis] - low[axis]; }
};
Extent extent_of(const std::vector<vec4>& spheres);  // of the finite numbers

// What rounding may move a place by, in cells, when an axis has so many of them: 12 units in the last place.
inline double coordinate_margin(double cells) { return cells * 12 * 0x1p-24; }

inline uint octave(float radius) { return std::bit_cast<uint>(radius) >> 23; }
std::vector<uint> octaves_of(const std::vector<vec4>& spheres);  // of the radii, each once, ascending

// n: spheres, whose number limits that of the cells.
GridPlan dense_plan(const Extent& extent, uint64_t n);

// The dense plan where no radius is more than twice another. Else cells as small as their number and the smallest
// radius allow, and so large that no radius of their level is longer than half of them; each level above doubles both.
GridPlan light_plan(const GridPlan& dense, const Extent& extent, const std::vector<uint>& octaves, uint64_t n);

}  // namespace spherepair
