// SPDX-License-Identifier: MIT
// The timing core on a clock of its own: what a sample costs besides its steps, K, rounds, turns and restarts.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/studies/study_sampling.h"
#include "tests/support/clocked_backend.h"

namespace spherepair {
namespace {

TEST(TimedTurns, TheFixedCostOfASampleIsNoPartOfItsSteps) {
  ClockedSession on;
  on["opengl"].fixed = 100e-6;
  on["cuda"].fixed = 5e-6;
  const auto samples = on.measure({on.contender("opengl", "same"), on.contender("cuda", "same")});
  for (const Samples& one : samples)
    for (const double seconds : one.seconds) EXPECT_NEAR(seconds, 10e-6, 1e-12) << one.label;
  EXPECT_NEAR(median(samples[0].fixed), 100e-6, 1e-9);
  EXPECT_NEAR(median(samples[1].fixed), 5e-6, 1e-9);
  EXPECT_NEAR(contest(samples[0], samples[1]).ratio, 1, 1e-9);
  const json record = to_json(samples[0]);
  EXPECT_NEAR(record.at("fixed_cost_us"), 100, 1e-3);
  EXPECT_NEAR(record.at("fixed_cost_interval_us").at(1), 100, 1e-3);
  EXPECT_EQ(record.at("fixed_cost_fitted"), 11);
  EXPECT_EQ(record.at("batch_ms").size(), 11u);
}

TEST(TimedTurns, TheDevicesOfAContestShareK) {
  ClockedSession on;
  on["opengl"].fixed = 100e-6;
  on["cpu"].step = 1e-3;
  const auto samples = on.measure({on.contender("cpu", "same"), on.contender("opengl", "same"),
                                   on.contender("cuda", "same"), on.contender("cuda", "other")});
  EXPECT_EQ(samples[1].plan.steps, samples[2].plan.steps);
  EXPECT_NE(samples[0].plan.steps, samples[1].plan.steps) << "the host's steps are longer by far";
  EXPECT_LT(samples[3].batch(), samples[1].batch()) << "without GLSL's fixed cost fewer steps are enough";
  const uint64_t largest = samples[1].batch();
  EXPECT_EQ(samples[1].plan.steps, (std::vector<uint64_t>{largest / 4, largest / 2, largest}));
}

TEST(TimedTurns, KIsSoLargeThatTheFixedCostHardlyCounts) {
  ClockedSession on;
  on["opengl"].fixed = 100e-6;
  const json wide = to_json(on.measure({on.contender("opengl")}).front());
  EXPECT_LE(wide.at("fixed_cost_share").get<double>(), 0.005 + 1e-9);
  EXPECT_FALSE(wide.at("bounded_by_longest").get<bool>());
  on.sampling.longest = 5e-3;
  const json bounded = to_json(on.measure({on.contender("opengl")}).front());
  EXPECT_GT(bounded.at("fixed_cost_share").get<double>(), 0.005);
  EXPECT_TRUE(bounded.at("bounded_by_longest").get<bool>());
  EXPECT_EQ(bounded.at("longest_batch_ms"), 5);
  EXPECT_LE(bounded.at("batch_ms")[0][2].get<double>(), 5 + 1e-6);
}

// As in OpenGL, where a batch behind one of many launches is late.
TEST(TimedTurns, AShortBatchAheadKeepsOneFromBeingLateBehindALongOne) {
  ClockedSession on;
  on["opengl"].late = 1e-3;
  const auto latest = [&] {
    const Samples samples = on.measure({on.contender("opengl")}).front();
    double most = 0;
    for (const auto& round : samples.batch_seconds)
      for (size_t k = 0; k < round.size(); ++k)
        most = std::max(most, round[k] - 10e-6 * double(samples.plan.steps[k]) - samples.fixed.front());
    return most;
  };
  EXPECT_GT(latest(), 0.9e-3);
  on.sampling.ahead = 0.25;
  EXPECT_LT(latest(), 1e-9);
}

// By least squares, each of these rounds would have another slope.
TEST(TimedTurns, LateBatchesDoNotMoveTheTimeOfAStep) {
  Samples samples;
  samples.plan.steps = {25, 50, 100};
  for (int round = 0; round < 11; ++round) {
    Turn turn;
    for (const uint64_t steps : samples.plan.steps) turn.seconds.push_back(60e-6 + 40e-6 * double(steps));
    turn.seconds[round < 7 ? 0 : round < 10 ? 1 : 2] += 1e-3;
    add_turn(samples, turn, uint64_t(round));
  }
  fit_rounds(samples);
  for (const double seconds : samples.seconds) EXPECT_NEAR(seconds, 40e-6, 1e-12);
  for (const double seconds : samples.fixed) EXPECT_NEAR(seconds, 60e-6, 1e-9);
}

TEST(TimedTurns, StudiesHideWhatABatchCostsInOpenGL) {
  ClockedSession on;
  on.sampling = study_sampling();
  on.sampling.clocks = on.clock.clocks();
  on["opengl"].step = 100e-6;
  on["opengl"].late = 1e-3;
  const Samples samples = on.measure({on.contender("opengl")}).front();
  EXPECT_LE(80e-6, 0.005 * double(samples.batch()) * 100e-6);
  for (const double seconds : samples.seconds) EXPECT_NEAR(seconds, 100e-6, 1e-12);
}

TEST(TimedTurns, ALongStepIsABatchOfItsOwnWithoutAFixedCost) {
  ClockedSession on;
  on["opengl"].step = 0.2;
  const Samples samples = on.measure({on.contender("opengl")}).front();
  EXPECT_EQ(samples.plan.steps, std::vector<uint64_t>{1});
  EXPECT_NEAR(samples.median_seconds(), 0.2, 1e-9);
  EXPECT_TRUE(to_json(samples).at("fixed_cost_us").is_null());
  EXPECT_EQ(to_json(samples).at("fixed_cost_fitted"), 0);
}

// Batches of which the longer took no longer have no slope that could be a time.
TEST(TimedTurns, DisturbedBatchesFallBackToTheLongest) {
  Samples samples;
  samples.plan.steps = {1, 2, 4};
  add_turn(samples, {.seconds = {9, 2, 4}}, 0);
  add_turn(samples, {.seconds = {8, 3, 5}}, 1);
  fit_rounds(samples);
  EXPECT_EQ(samples.seconds, (std::vector<double>{1, 1.25}));
  EXPECT_TRUE(samples.fixed.empty());
}

TEST(TimedTurns, EveryContenderHasAllRoundsHoweverSlowOrSteady) {
  ClockedSession on;
  on["cpu"].step = 5;
  for (const Samples& one : on.measure({on.contender("cpu", "same"), on.contender("cuda", "same")})) {
    EXPECT_EQ(one.seconds.size(), 11u) << one.label;
    EXPECT_GE(one.interval().coverage, 0.95);
  }
}

TEST(TimedTurns, TheContendersOfAContestFollowEachOtherInEveryRound) {
  ClockedSession on;
  on.sampling.rounds = 40;
  const auto samples =
      on.measure({on.contender("opengl", "a"), on.contender("opengl", "b"), on.contender("opengl", "c"),
                  on.contender("cuda", "a"), on.contender("cuda", "b"), on.contender("cuda", "c")});
  std::set<std::vector<uint64_t>> orders;
  for (size_t round = 0; round < 40; ++round) {
    std::vector<uint64_t> order;
    for (const Samples& one : samples) order.push_back(one.turn[round] - 6 * round);
    for (size_t k = 0; k < 3; ++k)
      EXPECT_EQ(std::max(order[k], order[k + 3]) - std::min(order[k], order[k + 3]), 1u) << "round " << round;
    EXPECT_LT(*std::ranges::max_element(order), 6u);
    orders.insert(order);
  }
  EXPECT_GT(orders.size(), 20u) << "of 3! orders of the contests and 2^3 within them";
}

// Each step takes longer than the one before, so a batch that does not restart, or has more steps ahead, takes longer.
TEST(TimedTurns, WhatMovesBeginsEveryBatchAlike) {
  ClockedSession on;
  std::vector<Contender> contenders;
  for (const char* name : {"cpu", "opengl", "cuda"}) {
    contenders.push_back(on.contender(name, "same"));
    contenders.back().batch = 8;
    contenders.back().restart = [](Backend& each) { static_cast<ClockedBackend&>(each).steps = 0; };
    on[name].drift = 1e-6;
  }
  const auto samples = on.measure(contenders);
  for (const Samples& one : samples) {
    EXPECT_EQ(one.plan.steps, (std::vector<uint64_t>{2, 4, 8}));
    for (size_t k = 0; k < one.seconds.size(); ++k) EXPECT_NEAR(one.seconds[k], samples[0].seconds[0], 1e-12);
  }
}

TEST(TimedTurns, TheLargestKMayBeGiven) {
  ClockedSession on;
  Contender fixed = on.contender("opengl");
  fixed.batch = 3;
  EXPECT_EQ(on.measure({fixed}).front().plan.steps, std::vector<uint64_t>{3});
}

// Three untimed steps go ahead, so a capture in the fourth of each is inside of the sample.
TEST(TimedTurns, ACaptureInsideOfASampleIsTakenAgain) {
  ClockedSession on;
  Contender contender = on.contender("opengl");
  contender.batch = 20;
  on.sampling.rounds = 1;
  on["opengl"].capture_every = 40;
  const Samples samples = on.measure({contender}).front();
  EXPECT_GT(samples.retaken, 0u);
  EXPECT_EQ(samples.prepared, Preparations{});
  EXPECT_EQ(to_json(samples).at("batches_retaken"), samples.retaken);
}

TEST(TimedTurns, ACaptureInsideOfEverySampleIsAnErrorThatNamesTheContender) {
  ClockedSession on;
  on["opengl"].capture_every = 1;
  try {
    on.measure({on.contender("opengl")});
    FAIL() << "samples were taken";
  } catch (const BackendError& error) {
    EXPECT_NE(std::string(error.what()).find("opengl steps: "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("graphs were captured"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("inside 3 samples"), std::string::npos) << error.what();
  }
}

TEST(TimedTurns, WhatAStepPreparesAsAPartOfItIsRecorded) {
  ClockedSession on;
  on["opengl"].capture_every = 1;
  Contender contender = on.contender("opengl");
  contender.prepares = true, contender.batch = 2, on.sampling.rounds = 5;
  const Samples samples = on.measure({contender}).front();
  EXPECT_EQ(samples.retaken, 0u);
  EXPECT_EQ(to_json(samples).at("prepared_in_samples").at("captures"), 10);
}

}  // namespace
}  // namespace spherepair
