// SPDX-License-Identifier: MIT
// Numbers derived from spheres keep the sign of the exact predicate and a small relative error.
#include <rapidcheck/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "bench/output/pair_geometry.h"
#include "bench/spheres/sphere_file.h"
#include "bench/spheres/sphere_rows.h"
#include "common/shared/exact.h"
#include "tests/oracle/adversarial.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

// Enough bits for every square of float32 to be exact.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<1200>, boost::multiprecision::et_off>;

Wide wide_square(const vec4& a, const vec4& b) {
  const Wide x = Wide(a.x) - b.x, y = Wide(a.y) - b.y, z = Wide(a.z) - b.z;
  return x * x + y * y + z * z;
}
Wide overlap_of(const vec4& a, const vec4& b) { return Wide(a.w) + b.w - sqrt(wide_square(a, b)); }

constexpr ListedPair both{0, 1, {}};

ListProblem problem_of(const vec4& a, const vec4& b) {
  ListProblem problem;
  for (const auto& [x, y, z, radius] : {a, b})
    problem.set.points.push_back({x, y, z}), problem.set.radii.push_back(radius);
  problem.set.offsets = {0, 2};
  problem.boxes.resize(1);
  return problem;
}

// At the cutoff, and at the float64 numbers next to it.
void expect_within(const vec4& a, const vec4& b, double cutoff) {
  ListProblem problem = problem_of(a, b);
  problem.set.radii.clear(), problem.inclusive = true;
  for (const double near : {cutoff, std::nextafter(cutoff, 0), std::nextafter(cutoff, INFINITY)}) {
    problem.cutoff = near;
    ASSERT_EQ(is_within_reach(problem, problem.boxes[0], both), wide_square(a, b) <= Wide(near) * near) << near;
  }
}

void expect_distance(const vec4& a, const vec4& b) {
  const Wide exact = sqrt(wide_square(a, b));
  ASSERT_LE(double(abs(Wide(distance_of(problem_of(a, b), both)) - exact)), double(exact) * 0x1p-50);
}

void expect_overlap(const vec4& a, const vec4& b) {
  const double overlap = contact_of(problem_of(a, b), both).overlap;
  const Wide exact = overlap_of(a, b);
  ASSERT_EQ(overlap > 0, exact > 0) << overlap << " for " << exact;
  ASSERT_EQ(overlap < 0, exact < 0) << overlap << " for " << exact;
  ASSERT_LE(double(abs(Wide(overlap) - exact)), double(abs(exact)) * 0x1p-50) << overlap << " for " << exact;
}

template <typename Check>
void for_hard_pairs(Check check) {
  for (const Family family : {Family::random_bits, Family::near_tangent, Family::quadruple, Family::quadruple_off,
                              Family::denormal, Family::extreme, Family::axis_offset, Family::beyond_double}) {
    const std::vector<vec4> pairs = adversarial_pairs(family, 0, by_form(1500u, 300u));
    for (size_t k = 0; k < pairs.size(); k += 2) {
      if (!finite_sphere(pairs[k]) || !finite_sphere(pairs[k + 1]) || pairs[k].w < 0 || pairs[k + 1].w < 0) continue;
      ASSERT_NO_FATAL_FAILURE(check(pairs[k], pairs[k + 1])) << int(family) << ", pair " << k / 2;
    }
  }
}

TEST(ContactGeometry, OverlapsOfHardPairsKeepSignAndDigits) { for_hard_pairs(expect_overlap); }

TEST(ContactGeometry, ACutoffDividesHardPairsExactly) {
  for_hard_pairs([](const vec4& a, const vec4& b) {
    const double reach = double(a.w) + b.w;
    if (!why_invalid(reach, true)) expect_within(a, b, reach);
    const double distance = distance_of(problem_of(a, b), both);
    if (!why_invalid(distance, true)) expect_within(a, b, distance);
    expect_distance(a, b);
  });
}

TEST(ContactGeometry, PointsOnTheCutoffAreWithinIt) {
  const float tiny = 0x1p-149f;
  for (const auto& [a, b, cutoff] : {std::tuple<vec4, vec4, double>{{1, 2, 3, 0}, {4, 6, 15, 0}, 13},
                                     {{0, 0, 0, 0}, {0, 0, 0, 0}, 0},
                                     {{0, 0, 0, 0}, {tiny, 0, 0, 0}, tiny},
                                     {{1e8f, 0, 0, 0}, {1e8f, 3e-30f, 4e-30f, 0}, 5e-30},
                                     {{-1e38f, 0, 0, 0}, {1e38f, 0, 0, 0}, 2.0 * 1e38f}}) {
    expect_within(a, b, cutoff);
    expect_within(b, a, cutoff);
  }
}

TEST(ContactGeometry, OverlapsOfPairsMadeByHand) {
  const float tiny = 0x1p-149f, one_above = 1 + 0x1p-23f, one_below = 1 - 0x1p-24f;
  const std::pair<vec4, vec4> pairs[] = {{{0, 0, 0, 0.5f}, {1, 0, 0, 0.5f}},
                                         {{0, 0, 0, 0.5f}, {one_below, 0, 0, 0.5f}},
                                         {{0, 0, 0, 0.5f}, {one_above, 0, 0, 0.5f}},
                                         {{0, 0, 0, 0.5f}, {one_below, 0x1p-30f, 0, 0.5f}},
                                         {{0, 0, 0, 1}, {0, 0, 0, 1}},
                                         {{0, 0, 0, 0}, {0, 0, 0, 0}},
                                         {{0, 0, 0, tiny}, {tiny, 0, 0, tiny}},
                                         {{0, 0, 0, 1}, {1, 0, 0, tiny}},
                                         {{-1e38f, 0, 0, 1e38f}, {1e38f, 1e-38f, 0, 1e38f}},
                                         {{-3e38f, 3e38f, 0, 3e38f}, {3e38f, -3e38f, 0, 3e38f}},
                                         {{0, 0, 0, 1e30f}, {1e30f, 0, 0, 1e-30f}},
                                         {{0.1f, 0.2f, 0.3f, 0.4f}, {0.5f, 0.6f, 0.7f, 0.8f}}};
  for (const auto& [a, b] : pairs) {
    expect_overlap(a, b);
    expect_overlap(b, a);
  }
}

// For equal radii, half way between the centres however small the distance.
TEST(ContactGeometry, PointsOfCloseCentresAreBetweenThem) {
  for (const float distance : {1e-3f, 1e-10f, 1e-20f, 1e-40f}) {
    EXPECT_EQ(contact_of(problem_of({0, 0, 0, 1}, {distance, 0, 0, 1}), both).point[0], double(distance) / 2);
  }
}

RC_GTEST_PROP(ContactGeometry, AtMostIsNeverLess, ()) {
  const float value = std::abs(bits_float(*rc::gen::arbitrary<uint>()));
  RC_PRE(std::isfinite(value) && value > 0);
  const double shown = std::strtod(at_most(value).c_str(), nullptr);
  RC_ASSERT(shown >= double(value));
  RC_ASSERT(shown <= double(value) * 1.11 || value < 1e-43f);
}

TEST(ContactGeometry, AtMostHasTwoDigits) {
  for (const auto& [value, text] : {std::pair(6.94e-7, "7e-07"),
                                    {6.9e-7, "6.9e-07"},
                                    {1.001, "1.1"},
                                    {9.91, "10"},
                                    {0.5, "0.5"},
                                    {99.1, "1e+02"},
                                    {1e-45, "1e-45"}})
    EXPECT_EQ(at_most(value), text);
}

}  // namespace
}  // namespace spherepair
