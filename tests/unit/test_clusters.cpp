// SPDX-License-Identifier: MIT
// What holds a cluster of spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/plan/grid_plan.h"
#include "common/shared/cluster.h"

namespace spherepair {
namespace {

// By the borders of cells, wherever the world is: all of a cluster is in the box of the row of cells that holds it.
TEST(DrawClusters, BordersOfCellsHoldThem) {
  for (const float offset : {0.0f, -1.0e3f, 1.0e5f, 3.0e6f}) {
    Scene scene = make_scene({.name = "uniform", .n = 30000, .radius = 0.5f});
    for (vec4& sphere : scene.positions) sphere.x += offset, sphere.z -= offset;
    Params p{};
    p.grid = grid_params(plan_grids(scene.positions).dense);
    std::ranges::sort(scene.positions, {}, [&](const vec4& sphere) { return slot_of(sphere, p.grid); });
    uint64_t in_rows = 0, tight = 0;
    const size_t clusters = scene.size() / CLUSTER;
    for (size_t c = 0; c + 1 < clusters; ++c) {
      const ::GridPosition begin = grid_position(scene.positions[c * CLUSTER], p.grid);
      const ::GridPosition end = grid_position(scene.positions[(c + 1) * CLUSTER], p.grid);
      if (!within_row(begin, end, p.grid)) continue;
      const vec4 low = lowest_in_row(begin, p.grid), high = highest_in_row(end, p.grid);
      ++in_rows;
      tight += high.y - low.y < 3 * 2 * 0.5f + 1e-5f * std::abs(offset);
      for (size_t i = c * CLUSTER; i < (c + 1) * CLUSTER; ++i) {
        const vec4& s = scene.positions[i];
        const double r = s.w;
        EXPECT_TRUE(double(s.x) - r >= low.x && double(s.y) - r >= low.y && double(s.z) - r >= low.z) << offset;
        EXPECT_TRUE(double(s.x) + r <= high.x && double(s.y) + r <= high.y && double(s.z) + r <= high.z) << offset;
      }
    }
    EXPECT_GT(in_rows, clusters / 6) << offset;
    EXPECT_EQ(tight, in_rows) << offset;
  }
}

}  // namespace
}  // namespace spherepair
