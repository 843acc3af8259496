// SPDX-License-Identifier: MIT
// Negative controls: the comparers object to what is wrong, and predicates known to be wrong are found out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/scene/scene.h"
#include "common/shared/motion.h"
#include "tests/oracle/naive.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/tally.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

constexpr size_t SPHERES = 400;

const std::vector<Pair>& right_pairs() {
  static const std::vector<Pair> pairs = brute_force_pairs(make_scene({.name = "uniform", .n = SPHERES}).positions);
  return pairs;
}

// What a backend that found these pairs would answer, without a contradiction in it.
StepResult result_of(std::vector<Pair> pairs, bool with_list) {
  std::sort(pairs.begin(), pairs.end());
  StepResult answer;
  answer.counts.resize(SPHERES);
  for (const Pair& pair : pairs) ++answer.counts[pair.first], ++answer.counts[pair.second];
  answer.totals.pairs = pairs.size();
  answer.totals.colliding_spheres = uint64_t(std::count_if(answer.counts.begin(), answer.counts.end(), colliding));
  answer.totals.fingerprint = fingerprint(pairs);
  if (with_list) answer.pairs = pairs;
  return answer;
}

// Two pairs exchange a partner: every count stays as it was, the set does not.
std::vector<Pair> swapped(std::vector<Pair> pairs) {
  for (Pair& left : pairs)
    for (Pair& right : pairs) {
      const Pair one = {left.first, right.second}, other = {right.first, left.second};
      if (!(one.first < one.second && other.first < other.second)) continue;
      if (std::count(pairs.begin(), pairs.end(), one) || std::count(pairs.begin(), pairs.end(), other)) continue;
      left = one;
      right = other;
      return pairs;
    }
  return pairs;
}

TEST(Controls, ComparerAcceptsTheRightSet) {
  ASSERT_GT(right_pairs().size(), 100u);
  EXPECT_EQ(first_mismatch(result_of(right_pairs(), true), right_pairs(), SPHERES), "");
  EXPECT_EQ(first_mismatch(result_of(right_pairs(), false), right_pairs(), SPHERES), "");
}

TEST(Controls, ComparerObjectsToADroppedPair) {
  for (size_t at : {size_t(0), right_pairs().size() / 2, right_pairs().size() - 1}) {
    std::vector<Pair> pairs = right_pairs();
    pairs.erase(pairs.begin() + ptrdiff_t(at));
    EXPECT_NE(first_mismatch(result_of(pairs, true), right_pairs(), SPHERES).find("missing"), std::string::npos);
    EXPECT_NE(first_mismatch(result_of(pairs, false), right_pairs(), SPHERES), "");
  }
}

TEST(Controls, ComparerObjectsToAnAddedPair) {
  std::vector<Pair> pairs = right_pairs();
  Pair extra = {0, 1};
  while (std::count(pairs.begin(), pairs.end(), extra)) ++extra.second;
  pairs.push_back(extra);
  EXPECT_NE(first_mismatch(result_of(pairs, true), right_pairs(), SPHERES).find("too much"), std::string::npos);
  EXPECT_NE(first_mismatch(result_of(pairs, false), right_pairs(), SPHERES), "");
}

TEST(Controls, ComparerObjectsToARepeatedPair) {
  std::vector<Pair> pairs = right_pairs();
  pairs.push_back(pairs.front());
  EXPECT_NE(first_mismatch(result_of(pairs, true), right_pairs(), SPHERES), "");
}

TEST(Controls, ComparerObjectsToSwappedPairsOfEqualCounts) {
  const std::vector<Pair> pairs = swapped(right_pairs());
  const StepResult given = result_of(pairs, false), right = result_of(right_pairs(), false);
  ASSERT_NE(pairs, right_pairs());
  ASSERT_EQ(given.counts, right.counts);
  ASSERT_EQ(given.totals.pairs, right.totals.pairs);
  EXPECT_NE(first_mismatch(result_of(pairs, true), right_pairs(), SPHERES), "");
  EXPECT_NE(first_mismatch(given, right_pairs(), SPHERES).find("fingerprint"), std::string::npos);
}

TEST(Controls, ComparerObjectsToContradictions) {
  const auto spoiled = [](const std::function<void(StepResult&)>& spoil) {
    StepResult answer = result_of(right_pairs(), true);
    spoil(answer);
    return first_mismatch(answer, right_pairs(), SPHERES);
  };
  EXPECT_NE(spoiled([](StepResult& answer) { ++answer.counts[7]; }), "");
  EXPECT_NE(spoiled([](StepResult& answer) { answer.counts.push_back(0); }), "");
  EXPECT_NE(spoiled([](StepResult& answer) { --answer.totals.pairs; }), "");
  EXPECT_NE(spoiled([](StepResult& answer) { ++answer.totals.colliding_spheres; }), "");
  EXPECT_NE(spoiled([](StepResult& answer) { answer.totals.fingerprint.b ^= 1; }), "");
  EXPECT_NE(spoiled([](StepResult& answer) { ++answer.totals.deferred; }), "");
}

TEST(Controls, StateHashSeesEveryBit) {
  const Scene scene = make_scene({.name = "random", .n = 20});
  const uint64_t right = state_hash(scene.positions, scene.velocities);
  for (size_t i = 0; i < scene.size(); ++i) {
    Scene moved = scene, faster = scene;
    moved.positions[i].y = nudged(moved.positions[i].y, 1);
    faster.velocities[i].y = nudged(faster.velocities[i].y, -1);
    EXPECT_NE(state_hash(moved.positions, moved.velocities), right);
    EXPECT_NE(state_hash(faster.positions, faster.velocities), right);
  }
  Scene exchanged = scene;
  std::swap(exchanged.positions[3], exchanged.positions[4]);
  EXPECT_NE(state_hash(exchanged.positions, exchanged.velocities), right);
}

std::vector<vec4> grazing() { return make_scene({.name = "grazing", .n = 1000}).positions; }

std::vector<Pair> pairs_by(const std::vector<vec4>& spheres, const Naive& naive) {
  std::vector<Pair> pairs;
  for (uint i = 0; i < spheres.size(); ++i)
    for (uint j = i + 1; j < spheres.size(); ++j)
      if (naive.collide(spheres[i], spheres[j])) pairs.push_back({i, j});
  return pairs;
}

void expect_found_out(const Naive& naive) {
  for (Family family : {Family::near_tangent, Family::quadruple, Family::quadruple_off, Family::axis_offset})
    EXPECT_GT(tally(family, 100'000, decider_of(naive.collide)).wrong, 100u) << "family " << int(family);
  const std::vector<vec4> spheres = grazing();
  EXPECT_TRUE(first_difference(pairs_by(spheres, naive), brute_force_pairs(spheres)));
}

TEST(Controls, NaivePredicateIsFoundOut) { expect_found_out(naive_plain); }

TEST(Controls, ContractedPredicateIsFoundOut) {
  if (!can_contract()) GTEST_SKIP() << "this CPU has no fused multiply-add";
  expect_found_out(naive_contracted);
  const auto wrong = [](const Naive& naive) {
    return tally(Family::near_tangent, 100'000, decider_of(naive.collide)).wrong;
  };
  EXPECT_NE(wrong(naive_contracted), wrong(naive_plain)) << "was it compiled with contraction at all?";
}

TEST(Controls, ContractedStepIsFoundOut) {
  if (!can_contract()) GTEST_SKIP() << "this CPU has no fused multiply-add";
  Random random(3);
  int differ = 0, differ_at_power_of_two = 0;
  for (int k = 0; k < 10'000; ++k) {
    const float position = float(random.uniform(-10, 10)), velocity = float(random.uniform(-10, 10));
    const auto same = [&](float dt) {
      return naive_contracted.advance(position, velocity, dt) == advance(position, velocity, dt, 0.0f);
    };
    differ += !same(0.001f);
    differ_at_power_of_two += !same(0x1p-6f);
  }
  EXPECT_GT(differ, 10);
  EXPECT_EQ(differ_at_power_of_two, 0);
}

// A filter without its margin decides what it must leave open.
TEST(Controls, FilterWithoutMarginIsFoundOut) {
  const Decider careless = [](std::span<const vec4> spheres) {
    std::vector<uint> verdicts(spheres.size() / 2);
    for (size_t k = 0; k < verdicts.size(); ++k)
      verdicts[k] = verdict_code(decide_pair(spheres[2 * k], spheres[2 * k + 1], 1, 0));
    return verdicts;
  };
  EXPECT_GT(tally(Family::near_tangent, 100'000, careless).wrong, 0u);
}

// As is one in float64, by what it rounds.
TEST(Controls, Float64WithoutMarginIsFoundOut) {
  const Decider careless = decider_of([](vec4 a, vec4 b) {
    const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z, r = double(a.w) + b.w;
    return x * x + y * y + z * z < r * r;
  });
  EXPECT_GT(tally(Family::beyond_double, 100'000, careless).wrong, 10'000u);
}

}  // namespace
}  // namespace spherepair
