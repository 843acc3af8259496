// SPDX-License-Identifier: MIT
#include "common/plan/dense_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/shared/cell.h"

namespace spherepair {
namespace {

double cells_along(double length, double side) { return std::floor(length / side) + 1; }

uint64_t slot_limit(uint64_t n) { return std::max(slots_per_sphere * n, least_slots); }

// Returns the smallest side of a cell, in metres, that is longer than the largest diameter and needs no more cells than
// the limit. A sphere then reaches less than one cell. If no such side exists, one cell holds all spheres.
double dense_side(const Extent& extent, uint64_t n) {
  const double limit = double(slot_limit(n));
  const double longest = std::max({extent.length(0), extent.length(1), extent.length(2)});
  const double one_cell = 2 * longest + 4.0 * double(extent.largest) + smallest_side;
  double side = std::max({2.0 * double(extent.largest) * (1 + 0x1p-8), longest * 0x1p-19, smallest_side});
  while (side < one_cell) {
    double cells = 1;
    for (int axis = 0; axis < 3; ++axis) cells *= cells_along(extent.length(axis), side);
    const double reach = 2.0 * double(extent.largest) / side + coordinate_margin(cells_along(longest, side));
    if (cells <= limit && reach < 1 - 0x1p-9) return side;
    side *= std::max(std::min(std::cbrt(cells / limit), 1000.0), 1.002);
  }
  return one_cell;
}

}  // namespace

// Ignores numbers that are not finite: spheres may have left float32, which must not spoil the cells of the others.
Extent extent_of(const std::vector<vec4>& spheres) {
  constexpr float most = std::numeric_limits<float>::max();
  const auto widen = [](float& low, float& high, float x) {
    if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
  };
  float x0 = most, y0 = most, z0 = most, r0 = most, x1 = -most, y1 = -most, z1 = -most, r1 = 0;
#pragma omp parallel for reduction(min : x0, y0, z0, r0) reduction(max : x1, y1, z1, r1) if (spheres.size() > 100000)
  for (size_t i = 0; i < spheres.size(); ++i) {
    const vec4& s = spheres[i];
    widen(x0, x1, s.x), widen(y0, y1, s.y), widen(z0, z1, s.z), widen(r0, r1, s.w);
  }
  Extent extent{{x0, y0, z0}, {x1, y1, z1}, std::min(r0, r1), r1};
  for (int axis = 0; axis < 3; ++axis)
    if (extent.low[axis] > extent.high[axis]) extent.low[axis] = extent.high[axis] = 0;
  return extent;
}

std::vector<uint> octaves_of(const std::vector<vec4>& spheres) {
  std::array<bool, 256> found{};
  for (const vec4& sphere : spheres) found[octave(sphere.w) & 255] = true;
  std::vector<uint> octaves;
  for (uint k = 0; k < found.size(); ++k)
    if (found[k]) octaves.push_back(k);
  return octaves;
}

GridPlan dense_plan(const Extent& extent, uint64_t n) {
  GridPlan plan;
  plan.cells = Cells::dense;
  plan.largest_radius = extent.largest;
  plan.equal_radii = extent.largest == extent.smallest;
  if (double(extent.largest) > huge_radius) return plan;
  plan.side = float(dense_side(extent, n));
  plan.slots = 1;
  for (int axis = 0; axis < 3; ++axis) {
    plan.origin[axis] = float(extent.low[axis]);
    plan.size[axis] = uint(cells_along(extent.length(axis), plan.side));
    plan.slots *= plan.size[axis];
  }
  return plan;
}

GridPlan light_plan(const GridPlan& dense, const Extent& extent, const std::vector<uint>& octaves, uint64_t n) {
  const uint top = octave(extent.largest);
  if (double(extent.largest) > huge_radius || extent.largest <= 2 * extent.smallest) return dense;
  const uint lowest = std::max({octave(extent.smallest), top > 24 ? top - 24 : 0, octave(float(smallest_side))});
  Extent finest = extent;
  finest.largest = std::bit_cast<float>((lowest + 1) << 23);
  GridPlan plan = dense_plan(finest, n);
  plan.first_octave = std::max(octave(plan.side / 2 / (1 + 0x1p-8f)) - 1, lowest);
  if (top <= plan.first_octave) return dense;
  plan.top_level = top - plan.first_octave;
  plan.largest_radius = std::bit_cast<float>((plan.first_octave + 1) << 23);
  plan.equal_radii = false;
  const GridParams grid = grid_params(plan);
  plan.levels = 0;
  for (const uint radius : octaves) plan.levels |= 1u << level_of(std::bit_cast<float>(radius << 23), grid);
  DenseLevel level = lowest_level(grid);
  for (uint k = 0; k <= plan.top_level; ++k) level = level_above(level);
  plan.slots = level.first_slot;
  return plan;
}

}  // namespace spherepair
