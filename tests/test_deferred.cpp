// SPDX-License-Identifier: MIT
// Pairs that the grid's search leaves to settle: those beyond a group's room, and those that float64 leaves undecided.
// They are decided ahead of a picture and once results are asked for, and with every step after one that left some.
#include "grid_answers.h"
#include "pictures.h"

namespace spherepair {
namespace {

class Deferred : public BackendTest {};

constexpr float touching = 1, overlapping = 1 - 0x1p-24f;  // of spheres of radius 1/2: the filter decides neither

// Pairs of spheres far from all others. So that a picture shows each, they stand in a plane.
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

const CollideOptions dense = {.method = Method::collide_grid, .grid = {.cells = Cells::dense, .keep_cells = false}};

TEST_P(Deferred, AreDecidedWhenAskedFor) {
  for (const float distance : {touching, overlapping})
    for (const uint pairs : {1u, 10u, 500u})
      for (const bool want_totals : {true, false}) {
        backend().upload(scene_of_pairs(pairs, distance));
        CollideOptions options = dense;
        options.want_totals = want_totals;
        const std::vector<Pair> expected = pairs_of(pairs, distance);
        for (const int steps_unasked : {3, 0, 1}) {
          for (int step = 0; step < steps_unasked; ++step) backend().collide(options);
          backend().collide(options);
          for (const uint contacts : backend().counts()) ASSERT_EQ(contacts, distance < touching ? 1u : 0u);
          const Collisions totals = backend().collisions();
          EXPECT_EQ(totals.pairs, expected.size());
          EXPECT_EQ(totals.deferred, pairs);
          EXPECT_EQ(totals.decided_by[distance < touching ? STAGE_DOUBLE : STAGE_INTEGER], pairs);
        }
        options.want_pairs = true;
        EXPECT_EQ(objection(ask(backend(), options), expected, 2 * pairs), "") << distance << ", " << pairs;
      }
  backend().check_guards();
}

TEST_P(Deferred, TakeALaunchOnlyWhereThereAreAny) {
  if (backend().info().name == "cpu") GTEST_SKIP() << "the CPU launches nothing";
  const auto launches = [&] {
    const uint64_t before = backend().work_counts().launches;
    backend().collide(dense);
    return backend().work_counts().launches - before;
  };
  backend().upload(scene_of_pairs(500, touching));
  backend().collide(dense);  // asks whether the spheres stand in cell order
  const uint64_t unasked = launches();
  EXPECT_EQ(launches(), unasked);
  backend().collisions();
  EXPECT_EQ(launches(), unasked + 1) << "settle";
  CollideOptions naive = dense;
  naive.exact = false;
  ask(backend(), naive);
  EXPECT_EQ(launches(), unasked + 1) << "a naive step defers none, which says nothing of these";
  backend().upload(scene_of_pairs(10, overlapping));  // float64 decides them all
  backend().collide(dense);
  EXPECT_EQ(launches(), unasked);
  backend().collisions();
  EXPECT_EQ(launches(), unasked);
}

// The colours are those of contacts, which nobody has asked for.
TEST_P(Deferred, AreDecidedBeforeTheyAreDrawn) {
  if (backend().info().name == "cpu") GTEST_SKIP() << "the others are compared with it";
  const Scene scene = scene_of_pairs(200, overlapping);
  const View view = make_view(frame(bounds_of(scene.positions), 70, 10, 50, 1.5), contact_look(), 300, 200);
  const auto reference = open_backend("cpu");
  reference->upload(scene);
  reference->collide(dense);
  const Picture expected = picture_of(*reference, view);
  backend().upload(scene);
  for (int step = 0; step < 2; ++step) {
    backend().collide(dense);
    EXPECT_EQ(objection(picture_of(backend(), view), expected, view), "") << step;
  }
}

INSTANTIATE_BACKENDS(Deferred);

}  // namespace
}  // namespace spherepair
