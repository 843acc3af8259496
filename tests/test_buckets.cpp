// SPDX-License-Identifier: MIT
// The sort by buckets of cells, where there are many, and where they hold many spheres.
#include <random>

#include "backends.h"
#include "grid_plan.h"

namespace spherepair {
namespace {

class MethodsByBuckets : public BackendTest {};

// The CPU's grid is the oracle.
void expect_right(Backend& backend, const Scene& scene) {
  const CollideOptions options = {.method = Method::collide_grid,
                                  .grid = {.cells = Cells::dense, .keep_order = false, .sort = Sort::buckets}};
  const auto oracle = open_backend("cpu");
  oracle->upload(scene);
  const Answer wanted = ask(*oracle, options);
  backend.upload(scene);
  const Answer answer = ask(backend, options);
  EXPECT_EQ(answer.totals.pairs, wanted.totals.pairs);
  EXPECT_EQ(answer.totals.fingerprint, wanted.totals.fingerprint);
  EXPECT_EQ(answer.counts, wanted.counts);
  backend.check_guards();
}

// More cells than one split tells apart.
TEST_P(MethodsByBuckets, InTwoSteps) { expect_right(backend(), make_scene({.name = "uniform", .n = 1'300'000})); }

// Most spheres lie on the floor of a box, so that a bucket has more than a group holds; in a small box all buckets
// would, were they of as many cells.
TEST_P(MethodsByBuckets, OfManySpheres) {
  Scene scene = make_scene({.name = "uniform", .n = 7000});
  std::minstd_rand random(5);
  for (const float side : {24.0f, 12.0f}) {
    std::uniform_real_distribution<float> place(0, side);
    for (size_t i = 0; i < scene.size(); ++i) {
      const bool on_the_floor = side > 12 && i % 4 != 0;
      scene.positions[i] = {place(random), place(random), place(random) / (on_the_floor ? 12 : 1), 0.5f};
    }
    for (const bool equal_radii : {true, false}) {
      scene.positions[0].w = equal_radii ? 0.5f : 0.375f;
      scene.equal_radii = equal_radii;
      expect_right(backend(), scene);
    }
  }
}

// Up to the largest tables; those of the largest scenes that a device holds were once split wrongly.
TEST(MethodsByBucketsPlan, EachSplitTellsItsBucketsApart) {
  for (uint64_t n = 1000; n < (1u << 30); n = n * 5 / 4)
    for (const double cells_a_sphere : {0.01, 0.3, 0.5, 1.0, 1.3, 2.0}) {
      const uint slots = uint(double(n) * cells_a_sphere);
      const BucketPlan plan = plan_buckets(n, slots);
      EXPECT_EQ(plan.buckets, (slots >> plan.shift) + 1);
      EXPECT_LE(1u << plan.shift, CELLS_PER_BUCKET);
      EXPECT_LE(n, uint64_t(plan.buckets) * SORT_EACH * SORT_BLOCK) << "on average";
      const uint first = plan.parent_shift == ONE_PARENT ? plan.buckets : (slots >> plan.parent_shift) + 1;
      EXPECT_LE(first, BUCKETS_AT_MOST) << n << ", " << cells_a_sphere;
      EXPECT_TRUE(plan.parent_shift == ONE_PARENT || plan.parent_shift > plan.shift);
    }
}

INSTANTIATE_BACKENDS(MethodsByBuckets);

}  // namespace
}  // namespace spherepair
