// SPDX-License-Identifier: MIT
// The sort by buckets of cells: many buckets, and buckets of many spheres.
#include <algorithm>
#include <random>

#include "api/open.h"
#include "common/plan/grid_plan.h"
#include "common/shared/cell.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

class MethodsByBuckets : public KernelTest {
 protected:
  void SetUp() override {
    KernelTest::SetUp();
    if (GetParam() == "cpu") GTEST_SKIP() << "the CPU's grid is the oracle";
  }
};

void expect_right(Backend& backend, const Scene& scene, uint block = 128, Cells cells = Cells::dense) {
  const CollideOptions options = {.method = Method::collide_grid,
                                  .block = block,
                                  .grid = {.cells = cells, .keep_order = false, .sort = Sort::buckets}};
  const auto oracle = open_backend("cpu");
  oracle->upload(scene);
  const StepResult wanted = run_step(*oracle, options);
  backend.upload(scene);
  const StepResult answer = run_step(backend, options);
  EXPECT_EQ(answer.totals.pairs, wanted.totals.pairs);
  EXPECT_EQ(answer.totals.fingerprint, wanted.totals.fingerprint);
  EXPECT_EQ(answer.counts, wanted.counts);
  backend.check_guards();
}

// More cells than one split tells apart.
TEST_P(MethodsByBuckets, InTwoSteps) { expect_right(backend(), make_scene({.name = "uniform", .n = 1'300'000})); }

// Buckets of few cells or of one, most of them empty.
TEST_P(MethodsByBuckets, OfFewSpheres) {
  for (const uint64_t n : {2, 3, 65, 700, 4097})
    for (const float ratio : {1.0f, 16.0f})
      for (const Cells cells : {Cells::dense, Cells::hashed})
        expect_right(backend(), make_scene({.name = "uniform", .n = n, .radius_ratio = ratio}), 128, cells);
  for (const uint64_t n : {2, 3, 65})
    for (const Cells cells : {Cells::dense, Cells::hashed})
      expect_right(backend(), make_scene({.name = "one_cell", .n = n}), 128, cells);
}

// A step that fails behind the sort leaves nothing that the next one would keep wrongly.
TEST_P(MethodsByBuckets, AfterAStepThatFailed) {
  if (std::string_view(GetParam()) != "opengl") GTEST_SKIP() << "only OpenGL reads the table in parts";
  OpenOptions open;
  open.texels = 100;
  const auto opengl = open_backend("opengl", open);
  opengl->upload(make_scene({.name = "uniform", .n = 5000}));
  CollideOptions options = {.method = Method::collide_grid,
                            .grid = {.cells = Cells::dense, .keep_order = false, .sort = Sort::buckets}};
  const StepResult wanted = run_step(*opengl, options);
  options.load_radii = true;
  CollideOptions too_long = options;
  too_long.api.texture_table = true;
  EXPECT_THROW(opengl->collide(too_long), BackendError);
  EXPECT_THROW(opengl->counts(), BackendError) << "the step that failed has results";
  EXPECT_EQ(run_step(*opengl, options).totals.fingerprint, wanted.totals.fingerprint);
}

// The search's groups are more than a dispatch takes along one axis.
TEST_P(MethodsByBuckets, SearchedByFoldedGroups) {
  expect_right(backend(), make_scene({.name = "uniform", .n = (MAX_GROUPS + 1000) * 32}), 32);
}

// Above 4 million spheres groups take several chunks of them in a row.
TEST_P(MethodsByBuckets, SearchedInStretches) {
  const Scene scene = make_scene({.name = "uniform", .n = 4'000'100});
  if (by_form(backend(), true, false)) expect_right(backend(), scene, 64);
  expect_right(backend(), scene, 256);
}

uint most_in_a_cell(const Scene& scene) {
  Params p{};
  p.grid = grid_params(plan_grid(scene, Cells::dense));
  std::vector<uint> held(p.grid.cell_slots);
  for (const vec4& sphere : scene.positions) ++held[slot_of(sphere, true, p.grid)];
  return std::ranges::max(held);
}

// Buckets with more spheres than a group holds. In the large box most spheres lie on the floor, whose buckets have
// more. In the small one all buckets would have more, if they were of as many cells. At the end a bucket of one cell
// has.
TEST_P(MethodsByBuckets, OfManySpheres) {
  Scene scene = make_scene({.name = "uniform", .n = 7000});
  std::minstd_rand random(5);
  std::uniform_real_distribution<float> within_a_cell(0, 0.25f);
  for (const float side : {24.0f, 12.0f}) {
    std::uniform_real_distribution<float> coordinate(0, side);
    for (size_t i = 0; i < scene.size(); ++i) {
      const bool on_the_floor = side > 12 && i % 4 != 0;
      scene.positions[i] = {coordinate(random), coordinate(random), coordinate(random) / (on_the_floor ? 12 : 1), 0.5f};
    }
    for (const bool equal_radii : {true, false}) {
      scene.positions[0].w = equal_radii ? 0.5f : 0.375f;
      scene.equal_radii = equal_radii;
      expect_right(backend(), scene);
    }
  }
  for (size_t i = 0; i < SORT_EACH * SORT_BLOCK + 100; ++i)
    scene.positions[i] = {6.3f + within_a_cell(random), 6.3f, 6.3f + within_a_cell(random), 0.5f};
  EXPECT_GT(most_in_a_cell(scene), SORT_EACH * SORT_BLOCK);
  expect_right(backend(), scene);
}

// In cell order `w` holds the sphere index where radii are equal: a step that loads radii must not read kept cells.
TEST_P(MethodsByBuckets, WhetherRadiiAreLoadedOrNot) {
  const Scene scene = make_scene({.name = "uniform", .n = 5000});
  backend().upload(scene);
  CollideOptions options = {.method = Method::collide_grid,
                            .grid = {.cells = Cells::dense, .keep_order = false, .sort = Sort::buckets}};
  const StepResult wanted = run_step(backend(), options);
  EXPECT_GT(wanted.totals.pairs, 0u);
  for (const bool load_radii : {true, false, true}) {
    options.load_radii = load_radii;
    const uint64_t sorts = backend().work_counts().sorts;
    const StepResult answer = run_step(backend(), options);
    EXPECT_EQ(answer.totals.fingerprint, wanted.totals.fingerprint) << load_radii;
    EXPECT_EQ(answer.counts, wanted.counts) << load_radii;
    EXPECT_GT(backend().work_counts().sorts, sorts) << "the cells are built anew";
  }
}

// Oversized buckets from many more tiles than one pass loops over.
TEST_P(MethodsByBuckets, OfOversizedBucketsFromManyTiles) {
  Scene scene = make_scene({.name = "uniform", .n = 40 * SPLIT_TILE});
  std::minstd_rand random(7);
  std::uniform_real_distribution<float> coordinate(0, 120);
  for (size_t i = 0; i < scene.size(); ++i)
    scene.positions[i] = {coordinate(random), coordinate(random), coordinate(random) / (i % 8 != 0 ? 16 : 1), 0.5f};
  expect_right(backend(), scene);
}

// Up to the largest tables; those of the largest scenes that a device holds were once split wrongly.
TEST(MethodsByBucketsPlan, EachSplitTellsItsBucketsApart) {
  for (uint64_t n = 8; n < (1u << 30); n = n * 5 / 4)
    for (const double cells_a_sphere : {0.0001, 0.01, 0.3, 0.5, 1.0, 1.3, 2.0}) {
      const uint slots = uint(double(n) * cells_a_sphere), least = n % 2 ? 1 : 64;
      const BucketPlan plan = plan_buckets(n, slots, least);
      EXPECT_TRUE(plan.shift == 0 || plan.buckets >= least) << n << ", " << cells_a_sphere;
      EXPECT_EQ(plan.buckets, (slots >> plan.shift) + 1);
      EXPECT_LE(1u << plan.shift, CELLS_PER_BUCKET);
      if (plan.shift > 0) {
        EXPECT_LE(n, uint64_t(plan.buckets) * SORT_EACH * SORT_BLOCK) << "on average";
      }
      const uint first = plan.parent_shift == ONE_PARENT ? plan.buckets : (slots >> plan.parent_shift) + 1;
      EXPECT_LE(first, BUCKETS_AT_MOST) << n << ", " << cells_a_sphere;
      EXPECT_TRUE(plan.parent_shift == ONE_PARENT || plan.parent_shift > plan.shift);
      if (plan.parent_shift == ONE_PARENT) {
        EXPECT_LE(n, uint64_t(SPLIT_TILE) * SORT_BLOCK) << "a thread of grid_sort for each tile";
      }
    }
}

INSTANTIATE_BACKENDS(MethodsByBuckets);

}  // namespace
}  // namespace spherepair
