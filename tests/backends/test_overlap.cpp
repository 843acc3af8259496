// SPDX-License-Identifier: MIT
// Steps as graphs, and sorts and moves that begin while the search before is under way.
#include <map>

#include "api/open.h"
#include "bench/studies/frames.h"
#include "common/backend/method_choice.h"
#include "tests/oracle/oracle.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

constexpr int TURNS = 4;

class Overlap : public BackendTest {
 protected:
  uint64_t overlapped() { return backend().work_counts().overlapped; }
  bool overlaps() {
    backend().upload(make_scene({.name = "uniform", .n = 10}));
    try {
      backend().collide(grid_step([](CollideOptions& o) { o.api.overlap = true; }));
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  }

  // By turns with radii and without, so that each sort has other words to write than the one before, of the same and of
  // other positions. Nothing waits between steps except where a result is requested, and that is of a sort that
  // overlaps a search.
  void expect_right(const Scene& scene, std::optional<bool> graph) {
    const auto step = [=](bool load_radii) {
      return grid_step([=](CollideOptions& o) {
        o.grid.cells = Cells::dense, o.grid.sort = Sort::buckets, o.load_radii = load_radii, o.api.graph = graph;
      });
    };
    const auto oracle = open_backend("cpu");
    for (Backend* each : {oracle.get(), &backend()}) each->upload(scene);
    for (int turn = 0; turn < TURNS; ++turn) {
      for (int k = 0; k < 3; ++k) backend().enqueue_collide(step((turn + k) % 2 == 0));
      const StepResult given = run_step(backend(), step(turn % 2 != 0)), wanted = run_step(*oracle, step(false));
      EXPECT_EQ(given.totals.pairs, wanted.totals.pairs) << turn;
      EXPECT_EQ(given.totals.fingerprint, wanted.totals.fingerprint) << turn;
      EXPECT_EQ(given.totals.colliding_spheres, wanted.totals.colliding_spheres) << turn;
      EXPECT_EQ(given.counts, wanted.counts) << turn;
      backend().enqueue_collide(step(turn % 2 == 0));
      for (Backend* each : {oracle.get(), &backend()}) each->move();
    }
    if (overlaps_) {
      EXPECT_GE(overlapped(), TURNS * 4u) << "three sorts and a move a turn";
    }
    EXPECT_EQ(hash_of_state(backend()), hash_of_state(*oracle));
    backend().check_guards();
  }
  bool overlaps_ = false;
};

TEST_P(Overlap, NeverChangesTheSet) {
  if (backend().info().on_host) GTEST_SKIP() << "the others are compared with it";
  overlaps_ = overlaps();
  for (const uint64_t n : {3000, by_form(backend(), 100'000, 12'000)}) {
    SceneOptions scene = {.name = "uniform", .n = n};
    for (const std::optional<bool>& graph : {std::optional<bool>(), std::optional<bool>(false)}) {
      scene.motion.method = MotionMethod::paper;
      expect_right(make_scene(scene), graph);
      scene.motion.method = MotionMethod::anchored;
      expect_right(make_scene(scene), graph);
    }
  }
}

TEST_P(Overlap, IsOfWhatNeedsNothingOfTheSearch) {
  if (!overlaps()) GTEST_SKIP() << "launches wait for one another here";
  const auto more = [&](auto act) {
    const uint64_t before = overlapped();
    act();
    return overlapped() - before;
  };
  backend().upload(make_scene({.name = "uniform", .n = 5000}));
  CollideOptions options = grid_step([](CollideOptions& o) { o.grid.sort = Sort::buckets, o.api.graph = false; });
  const auto collide = [&] { backend().enqueue_collide(options); };
  const auto move = [&] { backend().move(); };
  EXPECT_EQ(more(collide), 0u) << "nothing was there before";
  EXPECT_EQ(more(collide), 1u) << "split_tiles overlaps collide_grid";
  EXPECT_EQ(more(move), 1u);
  EXPECT_EQ(more(move), 0u) << "a move needs the move before";
  EXPECT_EQ(more(collide), 0u) << "spheres that move are not sorted";
  options.api.overlap = false;
  EXPECT_EQ(more(collide), 0u);
  EXPECT_EQ(more(move), 0u);
  options = grid_step([](CollideOptions& o) { o.grid.sort = Sort::counting, o.api.graph = false; });
  collide();  // whose grid_clear may overlap the move
  for (int k = 0; k < 2; ++k) EXPECT_EQ(more(collide), 0u) << "grid_clear writes the cells that are searched";
  options =
      grid_step([](CollideOptions& o) { o.grid.keep_order = true, o.grid.cells = Cells::dense, o.api.graph = false; });
  backend().upload(in_cell_order(make_scene({.name = "uniform", .n = 5000})));
  for (int k = 0; k < 2; ++k) EXPECT_EQ(more(collide), 0u);
  EXPECT_EQ(backend().work_counts().orders_kept, 2u);
  EXPECT_EQ(more(move), 0u) << "the search reads the spheres that are moved";
}

// In a graph of several steps a sort overlaps the search of the step before.
TEST_P(Overlap, IsWithinAGraphOfSeveralSteps) {
  if (!replays_steps(backend()) || !overlaps()) GTEST_SKIP() << "launches go out one by one here";
  const auto oracle = open_backend("cpu");
  const CollideOptions step = grid_step([](CollideOptions& o) { o.grid.sort = Sort::buckets; });
  for (const uint64_t n : {5000, 50'000, 5000}) {
    SCOPED_TRACE(n);
    const Scene scene = make_scene({.name = "uniform", .n = n});
    for (Backend* each : {oracle.get(), &backend()}) each->upload(scene);
    for (int k = 0; k < 3; ++k) backend().enqueue_collide(step);
    backend().finish();
    const WorkCounts before = backend().work_counts();
    for (int k = 0; k < 30; ++k) backend().enqueue_collide(step);
    backend().finish();
    const WorkCounts after = backend().work_counts();
    EXPECT_EQ(after.overlapped - before.overlapped, 30u);
    EXPECT_EQ(after.early - before.early, backend().info().name == "cuda" ? 60u : 0u)
        << "grid_sort and collide_grid get ready early";
    EXPECT_EQ(after.graphs_replayed - before.graphs_replayed, 1u + 1 + 1 + 2 + 1) << "of 1, 4, 16, 2 x 4 and 1 steps";
    EXPECT_EQ(after.kernels_replayed - before.kernels_replayed, 30u * 3) << "split_tiles, grid_sort, collide_grid";
    const StepResult given = run_step(backend(), step), wanted = run_step(*oracle, step);
    EXPECT_TRUE(same_result(given, wanted));
  }
}

class StepGraphs : public BackendTest {};

// A first step may still make buffers, a second is seen, and a third is captured when it is the same.
TEST_P(StepGraphs, AGraphIsReplayedWhileNothingChanges) {
  if (!replays_steps(backend())) GTEST_SKIP() << "launches go out one by one here";
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  const std::vector<Pair> expected = brute_force_pairs(scene.positions);
  backend().upload(scene);
  const CollideOptions options = grid_step([](CollideOptions& o) { o.api.graph = true; });
  for (int k = 0; k < 8; ++k) {
    const uint64_t replayed = backend().work_counts().graphs_replayed;
    EXPECT_EQ(first_mismatch(run_step(backend(), options), expected, scene.size()), "") << k;
    if (k >= 3) {
      EXPECT_EQ(backend().work_counts().graphs_replayed, replayed + 1) << k;
    }
  }
}

// The motion's own parameters change with every step; the search is launched with the same.
TEST_P(StepGraphs, AGraphIsReplayedWhileSpheresMove) {
  if (!replays_steps(backend())) GTEST_SKIP() << "launches go out one by one here";
  for (const MotionMethod method : {MotionMethod::paper, MotionMethod::anchored}) {
    SceneOptions options = {.name = "uniform", .n = 3000};
    options.motion.method = method;
    backend().upload(make_scene(options));
    const CollideOptions step = grid_step([](CollideOptions& o) { o.api.graph = true, o.grid.replan = false; });
    for (int k = 0; k < 8; ++k) {
      backend().move();
      const uint64_t replayed = backend().work_counts().graphs_replayed;
      backend().collide(step);
      if (k >= 3) {
        EXPECT_EQ(backend().work_counts().graphs_replayed, replayed + 1) << motion_name(method) << " " << k;
      }
    }
  }
}

// 1 + 4 + 16 + 64 steps, and the last 15 as 3 graphs of 4 steps and 3 of one. The step before the first replay is
// launched kernel by kernel.
TEST_P(StepGraphs, EqualStepsThatNobodyWaitsForShareGraphs) {
  if (!replays_steps(backend())) GTEST_SKIP() << "launches go out one by one here";
  const Scene scene = make_scene({.name = "uniform", .n = 900});
  Backend& cpu = *all_backends().front().backend;
  cpu.upload(scene);
  for (int k = 0; k < 102; ++k) cpu.move();
  const StepResult expected = run_step(cpu, {.method = Method::parallel});
  for (const auto& [most, graphs] : std::map<std::optional<uint>, uint64_t>{{{}, 10}, {4, 28}, {1, 100}}) {
    CollideOptions options = fast_method(backend());
    options.api.graph_steps = most;
    backend().upload(scene);
    for (int k = 0; k < 2; ++k) backend().step(options);  // which clear the results of none, and of the one before
    const uint64_t before = backend().work_counts().graphs_replayed;
    for (int k = 0; k < 99; ++k) backend().enqueue_step(options);
    backend().step(options);
    EXPECT_EQ(backend().work_counts().graphs_replayed - before, graphs) << most.value_or(0);
    EXPECT_TRUE(same_result(result_of(backend(), false), expected));
    EXPECT_EQ(hash_of_state(backend()), hash_of_state(cpu));
  }
}

// Held steps are launched before others, and those stay captured.
TEST_P(StepGraphs, StepsKeepTheirOrderWhenTheyChange) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU launches nothing";
  const Scene scene = make_scene({.name = "uniform", .n = 900});
  Backend& cpu = *all_backends().front().backend;
  cpu.upload(scene);
  backend().upload(scene);
  std::vector<CollideOptions> steps = {fast_method(backend()), fast_method(backend())};
  steps[1].block = 64;
  for (int turn = 0; turn < 3; ++turn)
    for (const CollideOptions& step : steps) {
      for (int k = 0; k < 7; ++k) backend().enqueue_step(step), cpu.move();
      backend().move(), cpu.move();
    }
  EXPECT_EQ(hash_of_state(backend()), hash_of_state(cpu));
  backend().enqueue_step(steps[0]), cpu.move();
  EXPECT_TRUE(same_result(run_step(backend(), steps[1]), run_step(cpu, {.method = Method::parallel})));
  const uint64_t captures = backend().preparations().captures;
  for (int turn = 0; turn < 3; ++turn)
    for (const CollideOptions& step : steps)
      for (int k = 0; k < 4; ++k) backend().step(step);
  EXPECT_LE(backend().preparations().captures - captures, 2u);  // each once
}

TEST_P(StepGraphs, AGraphHoldsOneOfAFewNumbersOfSteps) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU launches nothing";
  backend().upload(make_scene({.name = "uniform", .n = 100}));
  CollideOptions options = fast_method(backend());
  options.api.graph_steps = 3;
  EXPECT_THROW(backend().collide(options), std::invalid_argument);
  options.api.graph_steps = 4;
  if (replays_steps(backend()))
    EXPECT_NO_THROW(backend().collide(options));
  else
    EXPECT_THROW(backend().collide(options), std::invalid_argument);
}

// Another view is drawn after every step; the kernels of the step see none.
TEST_P(StepGraphs, AGraphIsReplayedWhileTheCameraMoves) {
  if (!replays_steps(backend())) GTEST_SKIP() << "launches go out one by one here";
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  backend().upload(scene);
  const CollideOptions options = grid_step([](CollideOptions& o) { o.api.graph = true; });
  for (int k = 0; k < 8; ++k) {
    const uint64_t replayed = backend().work_counts().graphs_replayed;
    backend().collide(options);
    if (k >= 3) {
      EXPECT_EQ(backend().work_counts().graphs_replayed, replayed + 1) << k;
    }
    drawing().draw(make_view(frame(bounds_of(scene.positions), 10 * k, 20, 40, 1), contact_look(), 64, 64), {});
  }
}

INSTANTIATE_BACKENDS(Overlap);
INSTANTIATE_BACKENDS(StepGraphs);

}  // namespace
}  // namespace spherepair
