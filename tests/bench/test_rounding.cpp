// SPDX-License-Identifier: MIT
// What rounding a file's numbers to float32 does to its pairs is bounded, and said.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/check/quad.h"
#include "bench/check/rounding_reach.h"
#include "bench/spheres/sphere_file.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

SphereRows rows_of(const std::vector<std::array<double, 4>>& exact) {
  SphereRows rows;
  rows.resize(exact.size(), 0, false, true);
  for (size_t i = 0; i < exact.size(); ++i)
    for (size_t q = 0; q < 4; ++q) rows.set(i, Quantity(q), {exact[i][q], float(exact[i][q]), false});
  return rows;
}

// A cubic lattice of 20 a side from (at, at, at) on.
std::vector<std::array<double, 4>> lattice(double at, double gap, double radius) {
  std::vector<std::array<double, 4>> all;
  for (int k = 0; k < 8000; ++k)
    all.push_back({at + gap * (k % 20), at + gap * (k / 20 % 20), at + gap * (k / 400), radius});
  return all;
}

Scene scene_of_rows(const SphereRows& rows) {
  return {.name = "rounded",
          .positions = rows.positions,
          .velocities = std::vector<vec4>(rows.positions.size(), vec4{0, 0, 0, 0}),
          .equal_radii = false};
}

// Of the numbers as they are: float128 holds differences, squares and sums of these exactly.
bool exactly_collide(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  Quad square = 0;
  for (size_t k = 0; k < 3; ++k) square += (Quad(a[k]) - Quad(b[k])) * (Quad(a[k]) - Quad(b[k]));
  const Quad reach = Quad(a[3]) + Quad(b[3]);
  return square < reach * reach;
}

TEST(SphereFileRounding, AShiftToTheMiddleKeepsContactsThatFloat32WouldLose) {
  const auto spheres = lattice(1000, 0.999999, 0.5);
  SphereRows kept = rows_of(spheres), shifted = rows_of(spheres);
  round_rows(kept, false);
  const Rounding rounding = round_rows(shifted, true);
  for (const double shift : rounding.shift) EXPECT_GT(shift, 990);
  EXPECT_LT(swept_pairs(kept.positions).size(), 22800u);
  EXPECT_EQ(swept_pairs(shifted.positions).size(), 22800u);
}

TEST(SphereFileRounding, NothingIsShiftedThatWouldLoseABit) {
  SphereRows rows = rows_of({{1000.1, 1000.1, 1, 1}, {1e-9, 1001.3, 1, 1}});
  const Rounding rounding = round_rows(rows, true);
  EXPECT_EQ(rounding.shift[0], 0) << "1e-9 - 500 is no float64";
  EXPECT_NE(rounding.shift[1], 0);
  EXPECT_EQ(rows.positions[0].x, 1000.1f);
  EXPECT_EQ(double(rows.positions[1].y), double(float(1001.3 - rounding.shift[1])));
  SphereRows whole = rows_of({{1000.5, 7, 1, 1}, {1001.5, 8, 1, 1}});
  const Rounding none = round_rows(whole, true);
  EXPECT_EQ(none.shift, (std::array<double, 3>{}));
  EXPECT_TRUE(none.reach.empty());
}

// Spheres that touch, on the file's lattice and off it: each pair that rounding decides is within its reach.
TEST(SphereFileRounding, EveryPairThatItChangesIsWithinItsReach) {
  const std::unique_ptr<Backend> cpu = open_backend("cpu");
  uint64_t changed_in_all = 0;
  for (const auto& spheres : {lattice(1000, 0.1, 0.05), lattice(1e5, 0.999999, 0.5), lattice(0.3, 0.1, 0.05 + 1e-9),
                              lattice(16777216, 1.0000001, 0.5)})
    for (const bool may_shift : {false, true}) {
      SphereRows rows = rows_of(spheres);
      const Rounding rounding = round_rows(rows, may_shift);
      uint64_t changed = 0;
      for (size_t i = 0; i < spheres.size(); ++i)
        for (const size_t j : {i + 1, i + 20, i + 400})
          changed +=
              j < spheres.size() && exactly_collide(spheres[i], spheres[j]) !=
                                        (relation(rows.positions[i], rows.positions[j]) == Relation::overlapping);
      EXPECT_LE(changed, pairs_within_reach(*cpu, scene_of_rows(rows), rounding, {}));
      changed_in_all += changed;
    }
  EXPECT_GT(changed_in_all, 10000u);
}

TEST(SphereFileRounding, PairsFarFromTouchingAreNotWithinItsReach) {
  const std::unique_ptr<Backend> cpu = open_backend("cpu");
  for (const double gap : {0.09, 0.11}) {
    SphereRows rows = rows_of(lattice(0.3, gap, 0.05));
    const Rounding rounding = round_rows(rows, false);
    EXPECT_GT(rounding.largest, 0);
    EXPECT_EQ(pairs_within_reach(*cpu, scene_of_rows(rows), rounding, {}), 0u);
  }
  EXPECT_EQ(reach_warning(0, {}), "");
  EXPECT_NE(reach_warning(12, {.largest = 0.5f}).find("12 pairs"), std::string::npos);
}

// A sphere that is smaller than what rounding moves it is certain to touch nothing.
TEST(SphereFileRounding, ReachBeyondTheRadiusLeavesNothingCertain) {
  const std::unique_ptr<Backend> cpu = open_backend("cpu");
  SphereRows rows = rows_of({{1e9 + 1, 0, 0, 0.5}, {1e9 + 2, 0, 0, 1}, {1e9 + 2.5, 0, 0, 1}});
  const Rounding rounding = round_rows(rows, false);
  EXPECT_GE(rounding.largest, 1);
  EXPECT_EQ(pairs_within_reach(*cpu, scene_of_rows(rows), rounding, {}), 3u);
}

}  // namespace
}  // namespace spherepair
