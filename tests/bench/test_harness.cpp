// SPDX-License-Identifier: MIT
// The comparing code itself, fed wrong answers: each is found, and named for what it is, by everything that compares.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/check/lockstep.h"
#include "tests/faults/faulty_session.h"

namespace spherepair {
namespace {

constexpr uint64_t spheres = 300;
const SceneOptions gas = {.name = "uniform", .n = spheres};

LockstepPlan lockstep_plan() {
  return {gas, 3, 1, {Method::sequential, Method::parallel, Method::collide_grid, Method::collide_group}, {64}};
}

std::vector<EqualityEntry> lockstep(Session& session, const LockstepPlan& plan = lockstep_plan()) {
  Progress progress;
  return check_lockstep(session, plan, progress);
}

// A session with answers and states of both backends for one step.
void compare_sets(Session& session, bool listed) {
  const Scene scene = make_scene(gas);
  for (const auto& backend : session.backends()) backend->upload(scene);
  const Configuration reference{session.find("cpu"), {.method = Method::sequential}};
  const Configuration configuration{session.find("opengl"), {.method = Method::collide_grid}};
  const StepResult expected = run_step(session, reference, listed);
  require_equal(session, {gas, 0}, reference, expected, configuration, run_step(session, configuration, listed));
}

TEST(Harness, AcceptsRightAnswers) {
  for (const bool listed : {false, true}) {
    Session session = session_with(Fault::none);
    EXPECT_EQ(error_of([&] { compare_sets(session, listed); }), "");
    EXPECT_EQ(session.comparisons.made(Comparisons::sets), 1u);
  }
}

// Once for each set of each step; the reference is the only configuration of its backend here.
TEST(Harness, LockstepSearchesWithTheReferenceOnceAStep) {
  Session session = session_with(Fault::none);
  LockstepPlan plan = lockstep_plan();
  plan.methods = {Method::collide_grid, Method::sequential};
  lockstep(session, plan);
  const uint64_t grid = session.reference().work_counts().sorts + session.reference().work_counts().cells_kept;
  EXPECT_EQ(session.reference().work_counts().steps - grid, plan.steps + 1);
}

TEST(Harness, RequireEqualNamesEveryWrongSet) {
  for (const bool listed : {false, true})
    for (const NamedFault& fault : set_faults()) {
      if (fault.fault == Fault::listed_pair && !listed) continue;
      Session session = session_with(fault.fault);
      expect_named(difference_of([&] { compare_sets(session, listed); }), fault, listed ? "listed" : "by totals");
      EXPECT_EQ(session.comparisons.made(Comparisons::sets), 0u) << "a difference counts as a comparison that passed";
    }
}

TEST(Harness, AnswersThatAllContradictThemselvesAlikeAreFound) {
  for (const Fault fault : {Fault::pair_total, Fault::colliding_total, Fault::sphere_count, Fault::listed_pair}) {
    const Opener both = [=](const std::string& name, const OpenOptions&) { return make_faulty(name, fault); };
    Session session({"cpu", "opengl"}, {}, both);
    EXPECT_NE(difference_of([&] { compare_sets(session, true); }), "") << int(fault);
  }
}

TEST(Harness, RequireSameStatesNamesEveryWrongState) {
  for (const NamedFault& fault : state_faults()) {
    Session session = session_with(fault.fault);
    for (const auto& backend : session.backends()) backend->upload(make_scene(gas));
    expect_named(difference_of([&] { require_same_states(session, {gas, 0}); }), fault, "states");
    EXPECT_EQ(session.comparisons.made(Comparisons::states), 0u);
  }
}

TEST(Harness, AWrongBitOfAWideStateIsFound) {
  for (const Precision precision : {Precision::compensated, Precision::float64}) {
    LockstepPlan plan = lockstep_plan();
    plan.scene.motion.precision = precision;
    Session session = session_with(Fault::wide_bit);
    EXPECT_NE(difference_of([&] { lockstep(session, plan); }).find("first in word"), std::string::npos);
  }
}

TEST(Harness, AStateThatIsNotFiniteIsAnErrorAlsoWhereAllAgree) {
  const Opener both = [](const std::string& name, const OpenOptions&) {
    return make_faulty(name, Fault::infinite_position, 2);
  };
  Session session({"cpu", "opengl"}, {}, both);
  const std::string message = error_of([&] { lockstep(session); });
  EXPECT_NE(message.find("step 2"), std::string::npos) << message;
  EXPECT_NE(message.find("sphere 3"), std::string::npos) << message;
}

TEST(Harness, LockstepNamesEveryFaultAtTheStepWhereItBegins) {
  for (const auto* faults : {&set_faults(), &state_faults()})
    for (const NamedFault& fault : *faults)
      for (const uint64_t from : {0, 2, 3}) {
        Session session = session_with(fault.fault, from);
        const std::string message = difference_of([&] { lockstep(session); });
        expect_named(message, fault, "lockstep");
        EXPECT_NE(message.find(fmt::format("step {} of", from)), std::string::npos) << message;
      }
}

TEST(Harness, LockstepComparesLargeSetsWithoutTheirLists) {
  LockstepPlan plan = lockstep_plan();
  plan.largest_list = 0;
  for (const NamedFault& fault : set_faults()) {
    if (fault.fault == Fault::listed_pair) continue;
    Session session = session_with(fault.fault, 1);
    expect_named(difference_of([&] { lockstep(session, plan); }), fault, "lockstep without lists");
  }
  Session session = session_with(Fault::listed_pair, 1);
  EXPECT_EQ(error_of([&] { lockstep(session, plan); }), "") << "nobody asked for a list";
}

TEST(Harness, LockstepChecksGuards) {
  Session session = session_with(Fault::guard_overwritten);
  EXPECT_NE(error_of([&] { lockstep(session); }).find("behind the end"), std::string::npos);
}

TEST(Harness, EveryConfigurationOfEveryBackendIsCompared) {
  Session session = session_with(Fault::none);
  LockstepPlan plan = lockstep_plan();
  plan.methods = {Method::sequential,     Method::parallel,         Method::collide_group, Method::collide_tiled,
                  Method::collide_square, Method::collide_triangle, Method::collide_grid,  Method::automatic};
  plan.blocks = {32, 128};
  std::multiset<std::string> labels;
  for (const EqualityEntry& entry : lockstep(session, plan))
    labels.insert(entry.configurations.begin(), entry.configurations.end());
  std::multiset<std::string> wanted = {"cpu sequential", "cpu parallel",         "cpu collide_grid",
                                       "cpu auto",       "cpu collide_group 32", "cpu collide_group 128"};
  for (const char* method : {"sequential", "parallel", "collide_group", "collide_tiled", "collide_square",
                             "collide_triangle", "collide_grid"})
    for (const uint block : plan.blocks)
      if (std::ranges::count(session.find("opengl")->methods(), method_from_name(method)))
        wanted.insert(fmt::format("opengl {} {}", method, block));
  wanted.insert({"opengl auto 32", "opengl auto"});
  EXPECT_EQ(labels, wanted);
  const uint64_t sets = wanted.size() - 3;  // less the references of all pairs and of both group sizes
  EXPECT_EQ(session.comparisons.made(Comparisons::sets), sets * 4);
  EXPECT_EQ(session.comparisons.made(Comparisons::states), 4u);
}

TEST(Harness, StepsBetweenComparisonsAreCountedWithTheLast) {
  LockstepPlan plan = lockstep_plan();
  plan.methods = {Method::parallel};
  for (const auto& [steps, every, compared] : {std::tuple{0, 1, 1}, {6, 3, 3}, {7, 3, 4}, {2, 5, 2}}) {
    plan.steps = uint64_t(steps), plan.every = uint64_t(every);
    Session session = session_with(Fault::none);
    lockstep(session, plan);
    EXPECT_EQ(session.comparisons.made(Comparisons::states), uint64_t(compared)) << steps << " by " << every;
  }
}

TEST(Harness, ABackendThatNothingIsAskedOfIsAnError) {
  Session session = session_with(Fault::no_methods);
  LockstepPlan plan = lockstep_plan();
  EXPECT_NE(error_of([&] { lockstep(session, plan); }).find("no result of opengl would be compared"),
            std::string::npos);
  Session alone({"cpu"}, {}, faulty_opener(Fault::none));
  plan.methods = {Method::sequential};
  EXPECT_NE(error_of([&] { lockstep(alone, plan); }).find("nothing would be compared"), std::string::npos);
}

TEST(Harness, FewerComparisonsThanPlannedAreAnError) {
  Comparisons comparisons;
  comparisons.plan("opengl", Comparisons::sets, 2);
  comparisons.plan("cuda", Comparisons::states, 1);
  comparisons.made("opengl", Comparisons::sets);
  comparisons.made("cuda", Comparisons::states);
  const std::string message = error_of([&] { comparisons.require_complete(); });
  EXPECT_NE(message.find("comparisons of sets of opengl: 2 planned, but 1 made"), std::string::npos) << message;
  comparisons.made("opengl", Comparisons::sets);
  EXPECT_EQ(error_of([&] { comparisons.require_complete(); }), "");
  EXPECT_EQ(comparisons.text(), "2 sets and 1 state compared, as many as planned");
  EXPECT_EQ(comparisons.to_json()["opengl"]["sets"].dump(), R"({"planned":2,"made":2})");
}

}  // namespace
}  // namespace spherepair
