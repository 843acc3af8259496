// SPDX-License-Identifier: MIT
// The oracle is itself checked: known answers, rationals made another way, and its sweep against its brute force.
#include <gmp.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/oracle/oracle.h"
#include "tests/oracle/tally.h"

namespace spherepair {
namespace {

Relation rational_relation(const vec4& a, const vec4& b) {
  const float left[4] = {a.x, a.y, a.z, a.w}, right[4] = {b.x, b.y, b.z, -b.w};
  for (int c = 0; c < 4; ++c)
    if (!std::isfinite(left[c]) || !std::isfinite(right[c])) return Relation::nonfinite;
  mpq_t difference, other, excess;
  mpq_inits(difference, other, excess, nullptr);
  for (int c = 0; c < 4; ++c) {
    mpq_set_d(difference, left[c]);
    mpq_set_d(other, right[c]);
    mpq_sub(difference, difference, other);
    mpq_mul(difference, difference, difference);
    (c < 3 ? mpq_add : mpq_sub)(excess, excess, difference);
  }
  const int sign = mpq_sgn(excess);
  mpq_clears(difference, other, excess, nullptr);
  return sign > 0 ? Relation::apart : sign < 0 ? Relation::overlapping : Relation::tangent;
}

TEST(Oracle, KnownAnswers) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(relation({0, 0, 0, 2}, {1, 2, 2, 1}), Relation::tangent);
  EXPECT_EQ(relation({0, 0, 0, 2}, {1, 2, nudged(2, -1), 1}), Relation::overlapping);
  EXPECT_EQ(relation({0, 0, 0, 2}, {1, 2, nudged(2, 1), 1}), Relation::apart);
  EXPECT_EQ(relation({0, 0, 0, 0}, {0, 0, 0, 0}), Relation::tangent);
  EXPECT_EQ(relation({-0.0f, 0, 0, 0}, {0, 0, 0, 0x1p-149f}), Relation::overlapping);
  EXPECT_EQ(relation({0, 0, 0, 1}, {infinity, 0, 0, 1}), Relation::nonfinite);
  EXPECT_EQ(relation({0, 0, 0, 1}, {0, 0, 0, std::nanf("")}), Relation::nonfinite);
  EXPECT_EQ(relation({0x1p127f, 0, 0, 0}, {-0x1p127f, 0, 0, 0x1.fffffep127f}), Relation::apart);
}

TEST(Oracle, AgreesWithRationals) {
  for (const FamilyPairs& plan : PLANS) {
    const std::vector<vec4> spheres = adversarial_pairs(plan.family, 1'000'000'000, 20'000);
    const std::vector<Relation> given = relations(spheres);
    for (size_t k = 0; k < given.size(); ++k)
      ASSERT_EQ(given[k], rational_relation(spheres[2 * k], spheres[2 * k + 1]))
          << "family " << int(plan.family) << ", " << show_pair(spheres[2 * k], spheres[2 * k + 1]);
  }
}

std::vector<vec4> random_spheres(size_t n, double box, double largest, float offset) {
  Random random(n);
  std::vector<vec4> spheres(n);
  for (vec4& sphere : spheres) {
    sphere = {float(random.uniform(0, box)), float(random.uniform(0, box)), float(random.uniform(0, box)), 0};
    sphere = {sphere.x + offset, sphere.y + offset, sphere.z + offset, float(std::pow(largest, random.uniform(0, 1)))};
  }
  return spheres;
}

TEST(Oracle, SweepEqualsBruteForce) {
  for (float offset : {0.0f, -1e5f, 1e6f})
    for (double largest : {1.0, 0.001, 30.0}) {
      const std::vector<vec4> spheres = random_spheres(700, 20, largest, offset);
      const std::vector<Pair> expected = brute_force_pairs(spheres);
      EXPECT_FALSE(expected.empty());
      EXPECT_EQ(swept_pairs(spheres), expected) << "largest radius " << largest << ", offset " << offset;
    }
}

TEST(Oracle, GroupsKeepTheirOwnPairs) {
  const std::vector<Pair> pairs = {{0, 1}, {0, 32}, {31, 32}, {32, 63}, {63, 64}};
  EXPECT_EQ(within_groups(pairs, 32), (std::vector<Pair>{{0, 1}, {32, 63}}));
  EXPECT_EQ(within_groups(pairs, 64), (std::vector<Pair>{{0, 1}, {0, 32}, {31, 32}, {32, 63}}));
}

}  // namespace
}  // namespace spherepair
