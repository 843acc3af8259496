// SPDX-License-Identifier: MIT
// ApiOptions: batches, steps, launches per step, the persistent kernel, OpenGL's table of cells in several textures.
#include "api/open.h"
#include "tests/oracle/oracle.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

class ApiOptionsOf : public BackendTest {};

TEST_P(ApiOptionsOf, OnlyWithoutABatchTheHostWaitsForEveryLaunch) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU launches nothing";
  backend().upload(make_scene({.name = "uniform", .n = 500}));
  for (const bool batch : {true, false}) {
    const WorkCounts before = backend().work_counts();
    backend().enqueue_collide(grid_step([=](CollideOptions& o) { o.api.batch = batch; }));
    const WorkCounts after = backend().work_counts();
    EXPECT_EQ(after.waits - before.waits, batch ? 0 : after.launches - before.launches);
  }
  CollideOptions both = grid_step([](CollideOptions& o) { o.api.graph = true, o.api.batch = false; });
  EXPECT_THROW(backend().enqueue_collide(both), std::invalid_argument);
}

// The move is one of the step's launches: without a batch it is waited for, else CUDA and Vulkan replay it with the
// rest.
TEST_P(ApiOptionsOf, AStepIsAMoveAndASearchTogether) {
  const Scene scene = make_scene({.name = "uniform", .n = 900});
  Backend& cpu = *all_backends().front().backend;
  cpu.upload(scene);
  for (int k = 0; k < 5; ++k) cpu.move();
  const StepResult expected = run_step(cpu, {.method = Method::parallel});
  CollideOptions options = fast_method(backend());
  for (const bool batch : {true, false}) {
    if (!backend().info().on_host) options.api.batch = batch;
    backend().upload(scene);
    for (int k = 0; k < 4; ++k) backend().enqueue_step(options);
    backend().finish();  // else steps may be held back
    const WorkCounts before = backend().work_counts();
    backend().step(options);
    const WorkCounts after = backend().work_counts();
    EXPECT_TRUE(same_result(result_of(backend(), false), expected));
    EXPECT_EQ(hash_of_state(backend()), hash_of_state(cpu));
    if (!batch && !backend().info().on_host) {
      EXPECT_EQ(after.waits - before.waits, 2u) << "move and collide_triangle";
    }
    if (batch && replays_steps(backend())) {
      EXPECT_EQ(after.graphs_replayed - before.graphs_replayed, 1u);
      EXPECT_EQ(after.launches - before.launches, 2u) << "the graph, and tally";
    }
  }
}

TEST_P(ApiOptionsOf, ThePersistentKernelTakesTheStepsThatLaunchesTake) {
  const Scene scene = make_scene({.name = "random", .n = 3000});
  backend().upload(scene);
  PersistentSteps* const persistent = backend().persistent_steps();
  if (!persistent) GTEST_SKIP() << "no persistent kernel in " << backend().info().name;
  for (const bool equal_radii : {true, false}) {
    Scene chosen = scene;
    chosen.equal_radii = equal_radii;
    backend().upload(chosen);
    for (int k = 0; k < 40; ++k) backend().enqueue_step(fast_method(backend()));
    backend().step(fast_method(backend()));
    const StepResult expected = result_of(backend(), false);
    const uint64_t state = hash_of_state(backend());
    backend().upload(chosen);
    const uint64_t launches = backend().work_counts().launches;
    persistent->enqueue_steps(1);
    persistent->enqueue_steps(30);
    EXPECT_EQ(backend().work_counts().launches, launches + 2);
    persistent->run_steps(10);
    EXPECT_TRUE(same_result(result_of(backend(), false), expected));
    EXPECT_EQ(hash_of_state(backend()), state);
    backend().check_guards();
  }
  SceneOptions anchored = {.name = "random", .n = 100};
  anchored.motion.method = MotionMethod::anchored;
  backend().upload(make_scene(anchored));
  EXPECT_THROW(persistent->run_steps(1), std::invalid_argument);
}

// The buckets' counts are left at 0 by the step before, whatever that was.
TEST_P(ApiOptionsOf, AStepLaunchesNoMoreThanItNeeds) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU launches nothing";
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  const std::vector<Pair> expected = brute_force_pairs(scene.positions);
  backend().upload(scene);
  const auto step = [](Sort sort, bool library_clear) {
    return grid_step([=](CollideOptions& o) {
      o.want_pairs = true, o.grid.sort = sort;
      o.api.graph = false, o.api.library_clear = library_clear;
    });
  };
  const auto launches = [&](const CollideOptions& options) {
    const uint64_t before = backend().work_counts().launches;
    backend().enqueue_collide(options);
    return backend().work_counts().launches - before;
  };
  for (const bool library_clear : {false, true, false})
    for (const Sort sort : {Sort::buckets, Sort::buckets, Sort::counting, Sort::buckets})
      EXPECT_EQ(first_mismatch(run_step(backend(), step(sort, library_clear)), expected, scene.size()), "");
  EXPECT_EQ(launches(step(Sort::buckets, false)), 3u) << "split_tiles, grid_sort, collide_grid";
  EXPECT_EQ(launches(step(Sort::counting, false)), 6u);
}

// Of a table of some 30,000 cells.
TEST(ApiOptionsTextures, ATableLongerThanATextureIsReadInParts) {
  std::unique_ptr<Backend> whole, parts, none;
  try {
    whole = open_backend("opengl");
    parts = open_backend("opengl", {.texels = 4096});
    none = open_backend("opengl", {.texels = 1000});
  } catch (const BackendError& missing) {
    ASSERT_FALSE(backend_required("opengl")) << missing.what();
    GTEST_SKIP() << missing.what();
  }
  const auto launches = [](Backend& backend, const CollideOptions& options) {
    run_step(backend, options);  // looks for an order and makes buffers
    const uint64_t before = backend.work_counts().launches;
    backend.collide(options);
    return backend.work_counts().launches - before;
  };
  for (const bool keep_order : {false, true}) {
    const CollideOptions options = grid_step([=](CollideOptions& o) {
      o.api.texture_table = true, o.want_pairs = true;
      o.grid.cells = Cells::dense, o.grid.keep_order = keep_order;
    });
    for (const SceneOptions& chosen :
         {SceneOptions{.name = "uniform", .n = 18000}, SceneOptions{.name = "clustered", .n = 18000},
          SceneOptions{.name = "lattice", .n = 17576}, SceneOptions{.name = "uniform", .n = 2}}) {
      const Scene scene = make_scene(chosen);
      for (Backend* backend : {whole.get(), parts.get()}) backend->upload(scene);
      EXPECT_EQ(run_step(*parts, options).pairs, run_step(*whole, options).pairs) << chosen.name;
      if (chosen.n > 2) {
        EXPECT_GE(launches(*parts, options), launches(*whole, options) + 4) << chosen.name;
      }
      parts->check_guards();
    }
  }
  const Scene scene = make_scene({.name = "uniform", .n = 18000});
  for (Backend* backend : {whole.get(), none.get()}) backend->upload(scene);
  EXPECT_THROW(none->collide(grid_step([](CollideOptions& o) { o.api.texture_table = true; })), BackendError);
  const CollideOptions open = grid_step([](CollideOptions& o) { o.want_pairs = true; });
  EXPECT_EQ(run_step(*none, open).pairs, run_step(*whole, open).pairs);
}

INSTANTIATE_BACKENDS(ApiOptionsOf);

}  // namespace
}  // namespace spherepair
