// SPDX-License-Identifier: MIT
// What two samples are said to show: nothing that too few or too scattered rounds cannot bear.
#include <gtest/gtest.h>

#include "bench/studies/crossover_sweep.h"
#include "bench/tables/api_verdict.h"
#include "tests/faults/faulty_session.h"

namespace spherepair {
namespace {

Samples samples_of(const char* backend, std::vector<double> seconds) {
  Samples samples;
  samples.label = samples.backend = backend;
  samples.plan.steps = {1};
  samples.seconds = std::move(seconds);
  return samples;
}
Contest of(std::vector<double> left, std::vector<double> right) {
  return contest(samples_of("opengl", std::move(left)), samples_of("cuda", std::move(right)));
}

const std::vector<double> calm = {1.00, 1.01, 0.99, 1.02, 0.98, 1.00, 1.01};

std::vector<double> times(double factor, std::vector<double> seconds) {
  for (double& value : seconds) value *= factor;
  return seconds;
}

TEST(Contests, ADifferenceIsOneThatEveryRoundShows) {
  EXPECT_EQ(ratio_text(of(times(1.3, calm), calm)), "1.30x [1.30, 1.30]");
  EXPECT_EQ(ratio_text(of(calm, times(2, calm))), "0.50x [0.50, 0.50]");
  EXPECT_EQ(ratio_text(of({1.1, 1.2, 1.3, 1.2, 1.2, 1.4}, {1, 1, 1, 1, 1, 1})), "1.20x [1.10, 1.40]");
}

TEST(Contests, NoDifferenceIsSeenWhereNoneOfWeightCouldHide) {
  EXPECT_EQ(ratio_text(of({1.00, 1.01, 0.99, 1.02, 0.98, 1.00, 1.01}, {1.01, 1.00, 1.00, 0.99, 1.01, 1.02, 0.99})),
            "no difference seen");
}

TEST(Contests, FewRoundsDecideNothing) {
  const Contest one = of({5}, {1});
  EXPECT_EQ(one.finding, Finding::undecided);
  EXPECT_EQ(ratio_text(one), "undecided: 1 round only");
  EXPECT_EQ(of({5, 5, 5, 5, 5}, {1, 1, 1, 1, 1}).finding, Finding::undecided);
  EXPECT_EQ(of({5, 5, 5, 5, 5, 5}, {1, 1, 1, 1, 1, 1}).finding, Finding::differ);
}

TEST(Contests, ScatteredRoundsAreNotDecidedAndTheirSpreadIsNamed) {
  const Contest loaded = of({1, 5, 1, 6, 1, 1, 7}, {4, 1, 5, 1, 1, 6, 1});
  EXPECT_EQ(loaded.finding, Finding::undecided);
  EXPECT_EQ(ratio_text(loaded), "undecided [0.17, 7.00] !");
}

// The naive predicate may not look slower because the machine was busy while it ran: one round says the opposite.
TEST(Contests, ALoadThatSlowsDownAlmostAllOfOneIsNoDifference) {
  const Contest exact = of({1.0, 1.0, 1.1, 1.0, 1.0, 1.05, 1.0}, {7.0, 7.1, 7.2, 7.0, 7.1, 6.9, 0.9});
  EXPECT_LT(exact.ratio, 0.2);
  EXPECT_EQ(exact.finding, Finding::undecided) << ratio_text(exact);
}

// By medians alone the two differ: almost every time of one is above every time of the other.
TEST(Contests, ARoundOfFewThatSaysTheOppositeLeavesItOpen) {
  const Contest denied = of({1.31, 1.32, 1.33, 1.34, 1.35, 1.36, 1.29}, {1.00, 1.01, 1.02, 1.03, 1.04, 1.05, 1.30});
  EXPECT_GT(denied.ratio, 1.2);
  EXPECT_EQ(denied.finding, Finding::undecided) << ratio_text(denied);
}

// A machine that is slower in some rounds than in others slows down both, so the ratios stay sharp.
TEST(Contests, ALoadThatLastsARoundCancels) {
  const std::vector<double> load = {1, 1.9, 1, 1.8, 1, 5, 1, 1.7, 1, 1, 1};
  EXPECT_EQ(ratio_text(of(times(1.02, load), load)), "1.02x [1.02, 1.02]");
  EXPECT_EQ(of(load, load).finding, Finding::no_difference);
}

// The medians' ratio would be 3.5 / 4.5.
TEST(Contests, TheRatioIsThatOfTheTurnsOfARound) {
  const Contest paired = of({1, 2, 3, 4, 5, 6}, {1, 1, 1, 8, 8, 8});
  EXPECT_DOUBLE_EQ(paired.ratio, 0.875);
  EXPECT_DOUBLE_EQ(paired.ratios.low, 0.5);
  EXPECT_DOUBLE_EQ(paired.ratios.high, 3);
}

Timing timed(const Contest& over_best) {
  return {.backend = "cpu", .kind = "gas", .n = 64, .chosen = "dense", .best = "parallel", .over_best = over_best};
}

TEST(Contests, TheAutomaticChoiceIsJudgedByTheInterval) {
  EXPECT_EQ(loss_of(timed(of(calm, calm))), Loss::within);
  EXPECT_EQ(loss_of(timed(of(times(5.187, calm), calm))), Loss::beyond);
  EXPECT_EQ(loss_of(timed(of({5}, {1}))), Loss::undecided);
  EXPECT_EQ(loss_of(timed(of({1, 5, 1, 6, 1, 1, 7}, {4, 1, 5, 1, 1, 6, 1}))), Loss::undecided);
}

// However sharp its ratio is.
TEST(Contests, AnUnsteadyTimeDecidesNothing) {
  Samples opengl = samples_of("opengl", times(1.3, calm)), cuda = samples_of("cuda", calm);
  opengl.others = cuda.others = 0.5;
  EXPECT_EQ(contest(opengl, cuda).finding, Finding::differ) << "half of the cores is not more than half";
  for (Samples* busy : {&opengl, &cuda}) {
    busy->others = 0.51;
    EXPECT_EQ(contest(opengl, cuda).finding, Finding::undecided);
    EXPECT_EQ(ratio_text(contest(opengl, cuda)), "undecided [1.30, 1.30] !");
    EXPECT_EQ(loss_of(timed(contest(opengl, cuda))), Loss::undecided);
    EXPECT_EQ(loss_of(timed(contest(cuda, opengl))), Loss::undecided);
    busy->others.reset();
  }
  const std::vector<double> wide = {1, 2.1, 1, 2.1, 1, 2.1, 1, 2.1, 1, 2.1, 1};
  EXPECT_EQ(of(times(1.3, wide), wide).finding, Finding::undecided) << "the interval of both is wider than 2x";
}

TEST(Contests, AreSummedUpByTableAndDirection) {
  const std::vector<ApiContest> all = {{"scale", of(times(1.3, calm), calm)},
                                       {"methods", of(calm, times(2, calm))},
                                       {"scale", of(times(1.5, calm), calm)},
                                       {"scale", of(calm, calm)},
                                       {"scale", of({5}, {1})}};
  EXPECT_EQ(summary_of("Vulkan", all),
            "Of 5 comparisons of time, Vulkan takes 1.30x to 1.50x CUDA's time in 2 (scale) and 0.50x to 0.50x CUDA's "
            "time in 1 (methods); no difference seen in 1, not decided by this data in 1");
}

TEST(Contests, WithoutAGpuNoApiIsCalledFaster) {
  const Session session = session_with(Fault::none);
  const std::vector<ApiContest> all = {{"scale", of(times(1.3, calm), calm)}};
  const std::vector<std::string> verdicts = api_verdicts(session, all);
  ASSERT_EQ(verdicts.size(), 2u);
  EXPECT_TRUE(verdicts[0].starts_with("OpenGL or CUDA: this run cannot say which is faster; ")) << verdicts[0];
  EXPECT_TRUE(verdicts[1].starts_with("Vulkan or CUDA: this run cannot say which is faster; ")) << verdicts[1];
}

}  // namespace
}  // namespace spherepair
