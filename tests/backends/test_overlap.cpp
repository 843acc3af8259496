// SPDX-License-Identifier: MIT
// Sorts and moves that begin while the search before is under way.
#include "api/open.h"
#include "bench/studies/frames.h"
#include "common/backend/method_choice.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

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
    for (int turn = 0; turn < 6; ++turn) {
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
      EXPECT_GE(overlapped(), 6u * 4u) << "three sorts and a move a turn";
    }
    const Backend::State moved = current_state(backend()), expected = current_state(*oracle);
    EXPECT_EQ(state_hash(moved.positions, moved.velocities, moved.wide),
              state_hash(expected.positions, expected.velocities, expected.wide));
    backend().check_guards();
  }
  bool overlaps_ = false;
};

TEST_P(Overlap, NeverChangesTheSet) {
  if (backend().info().on_host) GTEST_SKIP() << "the others are compared with it";
  overlaps_ = overlaps();
  for (const uint64_t n : {3000, 100'000}) {
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
  if (backend().info().name != "cuda" || !overlaps()) GTEST_SKIP() << "graphs of launches are CUDA's";
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
    EXPECT_EQ(after.early - before.early, 60u) << "grid_sort and collide_grid get ready early";
    EXPECT_EQ(after.graphs_replayed - before.graphs_replayed, 1u + 1 + 1 + 2 + 1) << "of 1, 4, 16, 2 x 4 and 1 steps";
    const StepResult given = run_step(backend(), step), wanted = run_step(*oracle, step);
    EXPECT_TRUE(same_result(given, wanted));
  }
}

INSTANTIATE_BACKENDS(Overlap);

}  // namespace
}  // namespace spherepair
