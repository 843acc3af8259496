// SPDX-License-Identifier: MIT
// What goes ahead of a timed sample, and so is not in it.
#include "bench/measure/timing.h"

#include <algorithm>

#include "api/open.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

class TimedSamples : public BackendTest {};

// A graph is made by the second of equal steps, after another contender's; none of the timed ones may be that.
TEST_P(TimedSamples, HoldNoMakingOfAGraph) {
  if (!replays_steps(backend())) GTEST_SKIP() << "launches go out one by one here";
  if (!is_gpu(backend())) GTEST_SKIP() << "in software no steps go ahead; a sample that made a graph is taken again";
  backend().upload(make_scene({.n = 500}));
  std::vector<bool> replayed;
  const auto contender = [&](Method method) {
    return Contender{.label = method_name(method), .backend = &backend(), .step = [&, method](Backend& each) {
                       const uint64_t before = each.work_counts().graphs_replayed;
                       each.collide({.method = method});
                       replayed.push_back(each.work_counts().graphs_replayed != before);
                     }};
  };
  for (const Method method : {Method::collide_triangle, Method::collide_square, Method::collide_triangle}) {
    replayed.clear();
    const Contender timed = contender(method);
    time_batch(timed, 10, steps_ahead(timed, 10), host_clocks());
    ASSERT_GE(replayed.size(), 10u);
    EXPECT_EQ(std::count(replayed.end() - 10, replayed.end(), true), 10) << method_name(method);
  }
}

TEST(TimeBatch, BeginsWhereItIsToldTo) {
  const auto cpu = open_backend("cpu");
  std::string calls;
  Contender contender{.label = "calls", .backend = cpu.get(), .step = [&](Backend&) { calls += 's'; }};
  const auto time = [&](uint64_t steps) {
    calls.clear();
    time_batch(contender, steps, steps_ahead(contender, steps), host_clocks());
    return calls;
  };
  EXPECT_EQ(time(3), "sss");
  contender.alternates = true;
  EXPECT_EQ(time(1), "ss") << "one goes ahead";
  contender.restart = [&](Backend&) { calls += 'r'; };
  EXPECT_EQ(time(2), "rsssss") << "three behind the restart, as on every backend";
  EXPECT_EQ(time(1), "rssss") << "the same for every K";
}

// What may not fall into a sample is counted where it happens.
TEST_P(TimedSamples, CountWhatIsCompiledAndAllocated) {
  if (backend().info().on_host) GTEST_SKIP() << "the host compiles nothing and has no buffers of a device";
  const auto fresh = open_backend(backend().info().name);  // no other test has compiled anything in it
  const auto change = [&](auto work) {
    const Preparations before = fresh->preparations();
    work();
    fresh->finish();
    return fresh->preparations() - before;
  };
  const auto scene = [](uint64_t n) { return make_scene({.n = n}); };
  fresh->upload(scene(500));
  EXPECT_GT(change([&] { fresh->upload(scene(70'000)); }).allocations, 0u);
  EXPECT_EQ(change([&] { fresh->upload(scene(70'000)); }), Preparations{});
  fresh->upload(scene(300));
  const CollideOptions unusual = {.method = Method::collide_square, .block = 1024, .exact = false, .load_radii = true};
  const auto search = [&] { fresh->enqueue_collide(unusual); };
  EXPECT_GT(change(search).compilations, 0u);
  const Preparations second = change(search);
  EXPECT_EQ(second.captures, replays_steps(backend()) ? 1u : 0u);
  EXPECT_EQ(second.compilations, 0u);
  EXPECT_EQ(change(search), Preparations{});
}

INSTANTIATE_BACKENDS(TimedSamples);

// Steps that change what the next one has to do are counted from the same start in every sample.
TEST(StudiesOfTime, EverySampleBeginsWhereTheFirstDid) {
  Session session({"cpu"}, {});
  uint64_t steps = 0, most = 0, restarts = 0;
  Contender falling{
      .label = "falling", .backend = session.find("cpu"), .step = [&](Backend&) { most = std::max(most, ++steps); }};
  falling.restart = [&](Backend&) { steps = 0, ++restarts; };
  falling.batch = 3;
  Sampling sampling;
  sampling.rounds = 4;
  Progress progress;
  const std::vector<Samples> samples = measure(session, {&falling, 1}, sampling, progress);
  EXPECT_EQ(samples.front().seconds.size(), 4u);
  EXPECT_EQ(most, 6u) << "three untimed ones ahead of three";
  EXPECT_GE(restarts, 4u);
}

TEST(StudiesOfTime, StepsInOneGoAreEnqueuedOncePerBatch) {
  Session session({"cpu"}, {});
  std::vector<uint64_t> counts;
  Contender persistent{.label = "persistent", .backend = session.find("cpu"), .step = [](Backend&) {}};
  persistent.steps = [&](Backend&, uint64_t steps) { counts.push_back(steps); };
  persistent.batch = 8;
  Sampling sampling;
  sampling.rounds = 1;
  Progress progress;
  measure(session, {&persistent, 1}, sampling, progress);
  std::ranges::sort(counts);
  EXPECT_EQ(counts, (std::vector<uint64_t>{2, 4, 8}));
}

}  // namespace
}  // namespace spherepair
