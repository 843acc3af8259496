// SPDX-License-Identifier: MIT
// How launches go out in each API, and what GLSL reads through textures.
#include "api/open.h"
#include "common/scene/camera.h"
#include "tests/oracle/oracle.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

class ApiOptionsOf : public BackendTest {};

TEST_P(ApiOptionsOf, OnlyWithoutABatchTheHostWaitsForEveryDispatch) {
  if (backend().info().name != "glsl") GTEST_SKIP() << "batches of dispatches are OpenGL's";
  backend().upload(make_scene({.name = "uniform", .n = 500}));
  for (const bool batch : {true, false}) {
    const WorkCounts before = backend().work_counts();
    backend().enqueue_collide(grid_step([=](CollideOptions& o) { o.api.batch = batch; }));
    const WorkCounts after = backend().work_counts();
    EXPECT_EQ(after.waits - before.waits, batch ? 0 : after.launches - before.launches);
  }
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
    whole = open_backend("glsl");
    parts = open_backend("glsl", {.texels = 4096});
    none = open_backend("glsl", {.texels = 1000});
  } catch (const BackendError& missing) {
    ASSERT_FALSE(backend_required("glsl")) << missing.what();
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

// A first step may still make buffers, a second is seen, and a third is captured when it is the same.
TEST_P(ApiOptionsOf, AGraphIsReplayedWhileNothingChanges) {
  if (backend().info().name != "cuda") GTEST_SKIP() << "graphs of launches are CUDA's";
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
TEST_P(ApiOptionsOf, AGraphIsReplayedWhileSpheresMove) {
  if (backend().info().name != "cuda") GTEST_SKIP() << "graphs of launches are CUDA's";
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

// Another view is drawn after every step; the kernels of the step see none.
TEST_P(ApiOptionsOf, AGraphIsReplayedWhileTheCameraMoves) {
  if (backend().info().name != "cuda") GTEST_SKIP() << "graphs of launches are CUDA's";
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  backend().upload(scene);
  const CollideOptions options = grid_step([](CollideOptions& o) { o.api.graph = true; });
  for (int k = 0; k < 8; ++k) {
    const uint64_t replayed = backend().work_counts().graphs_replayed;
    backend().collide(options);
    if (k >= 3) {
      EXPECT_EQ(backend().work_counts().graphs_replayed, replayed + 1) << k;
    }
    backend().draw(make_view(frame(bounds_of(scene.positions), 10 * k, 20, 40, 1), contact_look(), 64, 64), {});
  }
}

INSTANTIATE_BACKENDS(ApiOptionsOf);

}  // namespace
}  // namespace spherepair
