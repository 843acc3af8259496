// SPDX-License-Identifier: MIT
// What a step may leave out and what one API alone offers: each changes the time, never the set, and what one backend
// lacks is refused by name.
#include <array>

#include "common/plan/plan_watch.h"
#include "common/scene/contact_scene.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

class Ablations : public BackendTest {};

// Options that every backend has.
std::vector<CollideOptions> common_options() {
  return {grid_step([](CollideOptions& o) { o.grid.cells = Cells::dense; }),
          grid_step([](CollideOptions& o) { o.grid.cells = Cells::hashed; }),
          grid_step([](CollideOptions& o) { o.filter = false; }),
          grid_step([](CollideOptions& o) { o.filter = false, o.load_radii = true; }),
          grid_step([](CollideOptions& o) { o.load_radii = true; }),
          grid_step([](CollideOptions& o) { o.grid.keep_order = true; }),
          grid_step([](CollideOptions& o) { o.grid.keep_cells = true; }),
          grid_step([](CollideOptions& o) { o.grid.keep_cells = true, o.load_radii = true; }),
          grid_step([](CollideOptions& o) { o.api = {.graph = false, .texture_table = false, .batch = false}; }),
          {.method = Method::automatic, .load_radii = true}};
}

// Those of one API alone, or of a library.
std::vector<CollideOptions> special_options() {
  std::vector<CollideOptions> all = {grid_step([](CollideOptions& o) { o.grid.sort = Sort::radix; })};
  for (const Sort sort : {Sort::counting, Sort::buckets})
    for (std::optional<bool> ApiOptions::*trick :
         {&ApiOptions::graph, &ApiOptions::texture_table, &ApiOptions::library_clear, &ApiOptions::batch,
          &ApiOptions::overlap})
      all.push_back(grid_step([=](CollideOptions& o) { o.grid.sort = sort, o.api.*trick = true; }));
  return all;
}

std::vector<CollideOptions> offered(Backend& backend, const std::vector<CollideOptions>& wanted) {
  std::vector<CollideOptions> there;
  backend.upload(make_scene({.name = "uniform", .n = 10}));
  for (const CollideOptions& options : wanted) {
    try {
      backend.collide(options);
      there.push_back(options);
    } catch (const std::invalid_argument& refusal) {
      EXPECT_NE(std::string(refusal.what()).find(backend.info().name), std::string::npos) << refusal.what();
    }
  }
  return there;
}

TEST_P(Ablations, NoneChangesTheSet) {
  std::vector<CollideOptions> all = common_options();
  for (const CollideOptions& options : offered(backend(), special_options())) all.push_back(options);
  for (const SceneOptions& scene :
       {SceneOptions{.name = "uniform", .n = 1100}, SceneOptions{.name = "uniform", .n = 500, .radius_ratio = 16},
        SceneOptions{.name = "lattice", .n = 729}, SceneOptions{.name = "one_cell", .n = 90},
        SceneOptions{.name = "uniform", .n = 1}, SceneOptions{.name = "uniform", .n = 0}}) {
    const Scene made = make_scene(scene);
    expect_pairs(backend(), made, brute_force_pairs(made.positions), all);
  }
}

TEST_P(Ablations, WhatABackendLacksIsRefused) {
  const size_t there = offered(backend(), special_options()).size();
  if (backend().info().on_host) {
    EXPECT_EQ(there, 0u);
  } else if (backend().info().name == "opengl") {
    EXPECT_EQ(there, 8u) << "the texture, library_clear, batch and overlap with both sorts";
  } else {
    EXPECT_GE(there, 5u) << "Thrust, graph and library_clear with both sorts";
  }
  EXPECT_THROW(backend().collide({.method = Method::automatic, .filter = false}), std::invalid_argument);
}

TEST_P(Ablations, WithoutTheFilterEveryCandidateIsDecidedExactly) {
  const Scene scene = make_scene({.name = "uniform", .n = 1500});
  backend().upload(scene);
  const StepResult filtered = run_step(backend(), grid_step([](CollideOptions&) {}));
  const StepResult exact = run_step(backend(), grid_step([](CollideOptions& o) { o.filter = false; }));
  EXPECT_LT(filtered.totals.deferred, 10u);
  EXPECT_GT(exact.totals.deferred, 2 * exact.totals.pairs);
}

TEST_P(Ablations, WorkIsCounted) {
  const Scene scene = make_scene({.name = "random", .n = 1200});
  backend().upload(scene);
  const auto steps = [&](CollideOptions options, int moves) {
    const WorkCounts before = backend().work_counts();
    for (int k = 0; k < 3; ++k) {
      for (int m = 0; m < moves; ++m) backend().move();
      run_step(backend(), options);
    }
    WorkCounts after = backend().work_counts();
    return std::array{after.sorts - before.sorts, after.cells_kept - before.cells_kept, after.steps - before.steps};
  };
  EXPECT_EQ(steps(grid_step([](CollideOptions&) {}), 0), (std::array<uint64_t, 3>{3, 0, 3}));
  EXPECT_EQ(steps(grid_step([](CollideOptions& o) { o.grid.keep_cells = true; }), 0),
            (std::array<uint64_t, 3>{0, 3, 3}));
  EXPECT_EQ(steps(grid_step([](CollideOptions& o) { o.grid.keep_cells = true; }), 1),
            (std::array<uint64_t, 3>{3, 0, 3}));
}

// Behind a scene with contacts, whose searches for near pairs do not count any more.
TEST_P(Ablations, LoadsOfRadiiAndListsAreCounted) {
  Scene pushing = make_scene({.name = "gas", .n = 64});
  choose_contacts(pushing, {.law = ContactLaw::spring});
  backend().upload(pushing), backend().move();
  const auto counted = [&](const SceneOptions& scene, CollideOptions options) {
    backend().upload(make_scene(scene));
    run_step(backend(), options);
    const WorkCounts work = backend().work_counts();
    return std::array{work.steps, work.without_radii, work.lists};
  };
  const SceneOptions equal = {.name = "uniform", .n = 500}, unequal = {.name = "uniform", .n = 500, .radius_ratio = 4};
  const auto loading = grid_step([](CollideOptions& o) { o.load_radii = true; });
  const auto listing = grid_step([](CollideOptions& o) { o.want_pairs = true; });
  EXPECT_EQ(counted(equal, grid_step([](CollideOptions&) {})), (std::array<uint64_t, 3>{1, 1, 0}));
  EXPECT_EQ(counted(equal, loading), (std::array<uint64_t, 3>{1, 0, 0}));
  EXPECT_EQ(counted(unequal, grid_step([](CollideOptions&) {})), (std::array<uint64_t, 3>{1, 0, 0}));
  EXPECT_EQ(counted(equal, listing), (std::array<uint64_t, 3>{1, 1, 1}));
}

// Spheres that fly off together: planned once, all of them end in the cells along the border.
Scene in_the_wind(uint64_t n) {
  Scene scene = make_scene({.name = "uniform", .n = n});
  for (vec4& velocity : scene.velocities) velocity = {64, 0, 0, 0};
  scene.gravity = 0;
  return scene;
}

TEST_P(Ablations, CellsFollowSpheresThatLeaveThem) {
  const Scene scene = in_the_wind(backend().info().on_host ? 20000 : 2000);  // the CPU tests whole rows
  std::array<uint64_t, 2> candidates{};
  for (const bool replan : {false, true}) {
    backend().upload(scene);
    CollideOptions options = grid_step([=](CollideOptions& o) { o.grid.cells = Cells::dense, o.grid.replan = replan; });
    for (int step = 0; step < 60; ++step) {
      backend().move();
      if (step % 5 == 4) backend().collide(options);
    }
    options.want_pairs = true;
    const StepResult answer = run_step(backend(), options);
    EXPECT_EQ(first_mismatch(answer, swept_pairs(current_state(backend()).positions), scene.size()), "") << replan;
    EXPECT_EQ(backend().work_counts().plans > 5, replan);
    EXPECT_EQ(backend().work_counts().plans > 1, replan);
    options.filter = false;  // counts the candidate pairs
    candidates[replan] = run_step(backend(), options).totals.deferred;
  }
  EXPECT_GT(candidates[false], 2 * candidates[true]) << "without new cells those at the border fill up";
}

// So many that a device looks at some of them first.
TEST_P(Ablations, CellsFollowManySpheres) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU has all positions at hand";
  const Scene scene = in_the_wind(70000);
  backend().upload(scene);
  const CollideOptions options = grid_step([](CollideOptions& o) { o.grid.cells = Cells::dense; });
  for (int step = 0; step < 30; ++step) backend().move();
  const StepResult answer = run_step(backend(), options);
  EXPECT_EQ(backend().work_counts().plans, 2u);
  EXPECT_LT(backend().choice(options).others_in_cell, 1) << "the new cells are for a gas as well";
  EXPECT_EQ(answer.totals.pairs, swept_pairs(current_state(backend()).positions).size());
}

TEST(AblationsOnTheHost, ASampleTellsWhetherToPlan) {
  Scene scene = make_scene({.name = "uniform", .n = 3000});
  const GridPlans plans = plan_grids(scene.positions);
  PlanWatch watch(scene, plans);
  EXPECT_FALSE(watch.worthwhile(scene.positions, plans));
  std::vector<vec4> gathered = scene.positions, left = scene.positions;
  for (vec4& sphere : gathered) sphere.y *= 0.25f;
  for (size_t i = 0; i < left.size(); i += 50) left[i].z += 1000;
  EXPECT_TRUE(watch.worthwhile(gathered, plans));
  EXPECT_TRUE(watch.worthwhile(left, plans));
}

// The largest sphere is in no sample, and decides how large cells are all the same.
TEST(AblationsOnTheHost, ASampleIsPlannedForAsAll) {
  Scene scene = make_scene({.name = "uniform", .n = 20000});
  scene.positions[7].w *= 3;
  const GridPlans all = plan_grids(scene.positions);
  std::vector<vec4> sample;
  for (size_t i = 0; i < scene.size(); i += 10) sample.push_back(scene.positions[i]);
  const GridPlans anew = plan_grids_anew(all, sample, scene.size());
  EXPECT_EQ(anew.dense.side, all.dense.side);
  EXPECT_EQ(anew.hashed.side, all.hashed.side);
  EXPECT_EQ(anew.hashed.levels, all.hashed.levels);
  EXPECT_EQ(anew.hashed.slots, all.hashed.slots);
  for (int axis = 0; axis < 3; ++axis) EXPECT_LE(all.dense.size[axis] - anew.dense.size[axis], 1u);
  EXPECT_NEAR(anew.dense_occupancy, all.dense_occupancy, 0.2 * all.dense_occupancy);
  EXPECT_EQ(anew.chosen, all.chosen);
}

TEST(AblationsOnTheHost, PlansAreKeptWhereNothingLeaves) {
  Scene scene = make_scene({.name = "random", .n = 3000});
  GridPlans plans = plan_grids(scene.positions);
  PlanWatch watch(scene, plans);
  uint64_t moves = 0, checks = 0;
  for (; moves < 5000; ++moves) {
    watch.moved();
    if (!watch.needed()) continue;
    ++checks;
    EXPECT_FALSE(watch.replan(scene.positions, scene.size(), plans));
  }
  EXPECT_GE(checks, 3u);
  EXPECT_LE(checks, 20u) << "the re-check interval grows while the plans are kept";
}

INSTANTIATE_BACKENDS(Ablations);

}  // namespace
}  // namespace spherepair
