// SPDX-License-Identifier: MIT
// Pairs that a search leaves undecided: of the grid's through dense cells those beyond a group's room and those that
// float64 leaves undecided, of any other all that its filter does. They are decided before an image is drawn and once
// results are requested, and with every step after one that left some.
#include <fmt/format.h>

#include "api/open.h"
#include "tests/support/grid_results.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

class Deferred : public KernelTest {};

constexpr float touching = 1, overlapping = 1 - 0x1p-24f;  // of spheres of radius 1/2: the filter decides neither

// Pairs of spheres far from all others. So that an image shows each, they stand in a plane.
Scene scene_of_pairs(uint pairs, float distance) {
  std::vector<vec4> spheres;
  for (uint k = 0; k < pairs; ++k)
    for (const float x : {0.0f, distance}) spheres.push_back({x, 3.0f * float(k % 20), 3.0f * float(k / 20), 0.5f});
  return scene_of(std::move(spheres));
}

std::vector<Pair> pairs_of(uint pairs, float distance) {
  std::vector<Pair> all;
  for (uint k = 0; k < pairs && distance < touching; ++k) all.push_back({2 * k, 2 * k + 1});
  return all;
}

// Of pairs of neighbours in the scene's order, which collide_group finds as well.
std::vector<CollideOptions> searches(const Backend& backend) {
  std::vector<CollideOptions> all = every_method(backend, block_sizes().subspan(2, 1));
  std::erase_if(all, [](const CollideOptions& o) { return o.method == Method::collide_grid; });
  for (const Cells cells : {Cells::dense, Cells::hashed})
    all.push_back({.method = Method::collide_grid, .grid = {.cells = cells, .keep_cells = false}});
  return all;
}

TEST_P(Deferred, AreDecidedByACompleteSearch) {
  for (const CollideOptions& search : searches(backend()))
    for (const float distance : {touching, overlapping})
      for (const uint pairs : {1u, 10u, 500u}) {
        SCOPED_TRACE(fmt::format("{}, {} pairs at {}", describe(search), pairs, distance));
        backend().upload(scene_of_pairs(pairs, distance));
        CollideOptions options = search;
        const std::vector<Pair> expected = pairs_of(pairs, distance);
        for (const int enqueued : {3, 0, 1}) {
          for (int step = 0; step < enqueued; ++step) backend().enqueue_collide(options);
          backend().collide(options);
          for (const uint contacts : backend().counts()) ASSERT_EQ(contacts, distance < touching ? 1u : 0u);
          const Collisions totals = backend().collisions();
          EXPECT_EQ(totals.pairs, expected.size());
          EXPECT_EQ(totals.colliding_spheres, 2 * expected.size());
          EXPECT_EQ(totals.deferred, pairs);
          EXPECT_EQ(totals.decided_by[distance < touching ? STAGE_DOUBLE : STAGE_INTEGER], pairs);
        }
        options.want_pairs = true;
        EXPECT_EQ(first_mismatch(run_step(backend(), options), expected, 2 * pairs), "");
      }
  backend().check_guards();
}

// With every step after that, of the search that left some: none of what another one leaves.
TEST_P(Deferred, TakeALaunchOnlyWhereThereAreAny) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU launches nothing";
  const auto launches = [&](const CollideOptions& options) {
    const uint64_t before = backend().work_counts().launches;
    backend().enqueue_collide(options);
    return backend().work_counts().launches - before;
  };
  std::vector<CollideOptions> all = searches(backend());
  for (CollideOptions& search : all) search.api.graph = false;  // a replay is one launch
  for (const auto& [pairs, distance] : {std::pair{500u, touching}, {10u, overlapping}})
    for (const CollideOptions& search : all) {
      SCOPED_TRACE(fmt::format("{}, {} pairs", describe(search), pairs));
      const bool decides = search.grid.cells == Cells::dense && distance == overlapping;  // in float64, all of them
      backend().upload(scene_of_pairs(pairs, distance));
      backend().enqueue_collide(search);  // tests whether the spheres stand in cell order
      const uint64_t alone = launches(search);
      EXPECT_EQ(launches(search), alone);
      backend().collide(search);
      EXPECT_EQ(launches(search), alone + (decides ? 0 : 1)) << "resolve_undecided";
      CollideOptions naive = search;
      naive.exact = false;
      run_step(backend(), naive);
      EXPECT_EQ(launches(search), alone + (decides ? 0 : 1)) << "a naive step defers none, which says nothing of these";
      const CollideOptions other = all[search.method == Method::collide_square ? 0 : 2];
      for (int step = 0; step < 2; ++step) backend().enqueue_collide(other);
      const uint64_t of_other = launches(other);
      EXPECT_EQ(launches(other), of_other);
      backend().collide(other);
      EXPECT_EQ(launches(other), of_other + 1) << "what one search leaves says nothing of the other";
    }
}

// The colours are those of contacts, which no call has requested.
TEST_P(Deferred, AreDecidedBeforeTheyAreDrawn) {
  if (backend().info().on_host) GTEST_SKIP() << "the others are compared with it";
  const Scene scene = scene_of_pairs(200, overlapping);
  const View view = make_view(frame(bounds_of(scene.positions), 70, 10, 50, 1.5), contact_look(), 300, 200);
  const auto reference = open_backend("cpu");
  reference->upload(scene);
  reference->collide({.method = Method::collide_grid});
  const Image expected = image_of(*reference, view);
  for (const CollideOptions& search : searches(backend())) {
    backend().upload(scene);
    for (int step = 0; step < 2; ++step) {
      backend().collide(search);
      EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << describe(search) << ", " << step;
    }
  }
}

INSTANTIATE_BACKENDS(Deferred);

}  // namespace
}  // namespace spherepair
