// SPDX-License-Identifier: MIT
// What is timed is checked first, in the configuration that is timed: no wrong answer gets a time.
#include <gtest/gtest.h>

#include "bench/studies/crossover_sweep.h"
#include "bench/studies/sweep_point.h"
#include "bench/tables/study.h"
#include "tests/faults/faulty_session.h"

namespace spherepair {
namespace {

constexpr uint64_t spheres = 300;
const SceneOptions gas = {.name = "uniform", .n = spheres};

class Timed : public testing::Test {
 protected:
  void SetUp() override {
    plan_.sampling.rounds = 1;
    plan_.sampling.software_seconds = 1e-4;
  }
  std::string time(Fault fault, uint64_t from_step, Work work, bool exact = true, const SceneOptions& scene = gas) {
    Session session = session_with(fault, from_step);
    Study study(session, plan_, progress_);
    const std::string error = error_of([&] {
      study.time("test", scene, {{work, {session.find("opengl"), {.method = Method::collide_grid, .exact = exact}}}});
    });
    EXPECT_EQ(study.measurements.empty(), !error.empty()) << "a wrong answer was timed, or a right one was not";
    return error;
  }

  Plan plan_;
  Progress progress_;
};

// Predicted from the last one: 100 times as many spheres take 10,000 times as long.
TEST_F(Timed, SizesBehindOneThatTakesTooLongAreLeftOutTogether) {
  Session session = session_with(Fault::none, 0);
  const Study study(session, plan_, progress_);
  Samples last;
  last.seconds = {1e-3};
  const auto left_out = [&](const std::vector<uint64_t>& sizes) {
    SizeSequence sequence(study, sizes);
    EXPECT_TRUE(sequence.next());
    sequence.measured({&last, 1});
    EXPECT_TRUE(sequence.next()) << sequence.n();
    EXPECT_FALSE(sequence.next());
    EXPECT_FALSE(sequence.next()) << "no size behind it";
    return sequence.notes();
  };
  EXPECT_EQ(left_out({10, 20, 1000}),
            std::vector<std::string>{"n = 1000 is left out: 40 s on this machine. --full or --n includes it."});
  EXPECT_EQ(left_out({10, 20, 1000, 1001}),
            std::vector<std::string>{
                "n = 1000 to 1001 are left out: 40 s and more on this machine. --full or --n includes them."});
}

TEST_F(Timed, RightAnswersAreTimed) {
  for (const Work work : {Work::collide, Work::move, Work::step}) EXPECT_EQ(time(Fault::none, 0, work), "");
}

TEST_F(Timed, ANaiveVariantMayAnswerWronglyWhereItsExactTwinIsRight) {
  EXPECT_EQ(time(Fault::none, 0, Work::collide, false, {.name = "grazing", .n = 2000}), "");
}

TEST_F(Timed, AWrongSetIsNeverTimed) {
  for (const NamedFault& fault : set_faults()) {
    if (fault.fault == Fault::listed_pair) continue;
    expect_named(time(fault.fault, 0, Work::collide), fault, "collide");
    expect_named(time(fault.fault, 0, Work::collide, false), fault, "the exact twin of what is naive");
    expect_named(time(fault.fault, 1, Work::step), fault, "a step's set after the move");
  }
}

TEST_F(Timed, AWrongStateIsNeverTimed) {
  for (const NamedFault& fault : state_faults())
    for (const Work work : {Work::move, Work::step}) expect_named(time(fault.fault, 1, work), fault, "after the move");
}

TEST_F(Timed, ASweepTimesNoWrongSet) {
  const auto sweep = [&](Fault fault) {
    Session session = session_with(fault);
    const SweepPoint point{.n = spheres, .packing_fraction = 0.3, .methods = {Method::collide_grid}, .block = 64};
    return error_of([&] {
      const PointTimes times = time_point(session, point, {}, plan_.sampling, progress_);
      EXPECT_EQ(times.measurements.size(), 2u);
      EXPECT_EQ(session.comparisons.made(Comparisons::sets), 2u);
    });
  };
  EXPECT_EQ(sweep(Fault::none), "");
  for (const NamedFault& fault : set_faults())
    if (fault.fault != Fault::listed_pair) expect_named(sweep(fault.fault), fault, "sweep");
}

TEST_F(Timed, ACrossoverTimesNoWrongSet) {
  const auto crossover = [&](Fault fault) {
    Session session = session_with(fault);
    const CrossoverOptions options{.rounds = 1};
    CrossoverSweep sweep(session, options, [] {});
    return error_of([&] { sweep.run(sphere_kinds().first(1), {spheres}); });
  };
  EXPECT_EQ(crossover(Fault::none), "");
  for (const NamedFault& fault : set_faults())
    if (fault.fault != Fault::listed_pair) expect_named(crossover(fault.fault), fault, "crossover");
}

}  // namespace
}  // namespace spherepair
