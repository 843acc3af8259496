// SPDX-License-Identifier: MIT
// Spheres whose numbers follow their places are sorted by counting, others by buckets, and nothing changes but the
// time.
#include "backends.h"
#include "frames.h"
#include "number_order.h"

namespace spherepair {
namespace {

class NumberOrder : public BackendTest {};

Scene scene_in(bool cell_order, uint64_t n) {
  const Scene scene = make_scene({.name = "uniform", .n = n});
  return cell_order ? in_cell_order(scene) : scene;
}

TEST(NumberOrderOnTheHost, IsSeenInASample) {
  for (const uint64_t n : {2000, 100000})
    for (const bool ordered : {false, true}) {
      const Scene scene = scene_in(ordered, n);
      EXPECT_EQ(numbers_follow_cells(scene.positions, plan_grid(scene, Cells::dense)), ordered) << n;
      EXPECT_FALSE(numbers_follow_cells(scene.positions, plan_grid(scene, Cells::hashed))) << n;
    }
  EXPECT_FALSE(numbers_follow_cells({}, GridPlan{}));
}

TEST_P(NumberOrder, DecidesHowSpheresAreSorted) {
  if (backend().info().name == "cpu") GTEST_SKIP() << "the CPU sorts in one way";
  for (const bool ordered : {false, true}) {
    const Scene scene = scene_in(ordered, 500000);
    backend().upload(scene);
    backend().move();  // none stands in cell order any more
    CollideOptions options = {.method = Method::collide_grid, .grid = {.cells = Cells::dense, .keep_order = false}};
    backend().time_stages(true);
    backend().collide(options);
    bool counted = false;
    for (const StageTime& stage : backend().stage_times()) counted |= stage.stage == std::string("grid_scatter");
    backend().time_stages(false);
    EXPECT_EQ(counted, ordered);
    const Fingerprint fingerprint = backend().collisions().fingerprint;
    options.grid.sort = ordered ? Sort::buckets : Sort::counting;
    options.grid.keep_cells = false;
    backend().collide(options);
    EXPECT_EQ(backend().collisions().fingerprint, fingerprint);
  }
}

INSTANTIATE_BACKENDS(NumberOrder);

}  // namespace
}  // namespace spherepair
