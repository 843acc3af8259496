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
  if (backend().info().name != "cuda") GTEST_SKIP() << "graphs of launches are CUDA's";
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
    time_batch(contender(method), 10);
    ASSERT_GE(replayed.size(), 10u);
    EXPECT_EQ(std::count(replayed.end() - 10, replayed.end(), true), 10) << method_name(method);
  }
}

TEST(TimeBatch, BeginsWhereItIsToldTo) {
  const auto cpu = open_backend("cpu");
  std::string calls;
  Contender contender{.label = "calls", .backend = cpu.get(), .step = [&](Backend&) { calls += 's'; }};
  time_batch(contender, 3);
  EXPECT_EQ(calls, "sss");
  contender.alternates = true;
  time_batch(contender, 1);
  EXPECT_EQ(calls, "sssss") << "one goes ahead";
  contender.restart = [&](Backend&) { calls += 'r'; };
  calls.clear();
  time_batch(contender, 2);
  EXPECT_EQ(calls, "srss") << "what goes ahead is before the beginning";
}

INSTANTIATE_BACKENDS(TimedSamples);

}  // namespace
}  // namespace spherepair
