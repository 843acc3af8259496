// SPDX-License-Identifier: MIT
// What Method::automatic takes, by the rule alone. The choice needs no device, so that of devices which are not here is
// tested too.
#include <gtest/gtest.h>

#include "common/backend/checks.h"
#include "common/backend/method_choice.h"
#include "common/scene/scene.h"

namespace spherepair {
namespace {

Method taken(const char* device, const std::vector<vec4>& spheres, CollideOptions options = {}) {
  BackendInfo info;
  info.name = device;
  info.on_host = info.name == "cpu";
  info.details["threads"] = "16";
  options.method = Method::automatic;
  return chosen_method(info, spheres.size(), plan_grids(spheres), options);
}
Method taken(const char* device, const SceneOptions& scene, const CollideOptions& options = {}) {
  return taken(device, make_scene(scene).positions, options);
}

TEST(MethodsOnTheHost, AutoFollowsTheCrossovers) {
  for (const char* device : {"cuda", "opengl"}) {
    SCOPED_TRACE(device);
    const auto takes = [&](const char* scene, uint64_t n) { return taken(device, {.name = scene, .n = n}); };
    for (const uint64_t n : {64, 1024, 5000}) EXPECT_EQ(takes("uniform", n), Method::collide_triangle) << n;
    EXPECT_EQ(takes("uniform", 8000), Method::collide_grid);
    for (const uint64_t n : {64, 1024, 5000}) EXPECT_EQ(takes("clustered", n), Method::collide_triangle) << n;
    EXPECT_EQ(takes("clustered", 16384), Method::collide_grid);
    for (const uint64_t n : {64, 128, 9000}) EXPECT_EQ(takes("one_cell", n), Method::collide_square) << n;
    const auto with_radii = [&](uint64_t n) {
      SceneOptions radii = {.name = "uniform", .n = n, .radius_ratio = 16};
      radii.packing_fraction = 0.01;
      return taken(device, radii);
    };
    for (const uint64_t n : {64, 4096, 16384}) EXPECT_EQ(with_radii(n), Method::collide_triangle) << n;
    for (const uint64_t n : {256, 2048}) EXPECT_EQ(with_radii(n), Method::collide_square) << n;
    EXPECT_EQ(with_radii(24'000), device[0] == 'c' ? Method::collide_grid : Method::collide_triangle);
    EXPECT_EQ(with_radii(32'768), Method::collide_grid);
  }
}

// Of cells that are hashed, as a stray sphere or many levels of radii want it, the grid is ahead later.
TEST(MethodsOnTheHost, AutoTakesHashedCellsLater) {
  for (const auto& [device, few] : {std::pair{"cuda", 9000}, {"opengl", 9000}, {"cpu", 12'000}})
    for (const uint64_t n : {few, 30'000}) {
      std::vector<vec4> spheres = make_scene({.name = "uniform", .n = n}).positions;
      EXPECT_EQ(taken(device, spheres), Method::collide_grid) << device << " " << n;
      spheres[5].x = 1e9f;
      EXPECT_EQ(plan_grids(spheres).plan(Cells::automatic).cells, Cells::hashed);
      EXPECT_EQ(taken(device, spheres) == Method::collide_grid, n == 30'000) << device << " " << n;
      SceneOptions radii = {.name = "uniform", .n = n, .radius_ratio = 1000};
      radii.packing_fraction = 0.01;
      EXPECT_NE(taken(device, radii, {.grid = {.cells = Cells::hashed}}), Method::collide_grid) << device << " " << n;
    }
}

TEST(MethodsOnTheHost, AutoOnTheCpuGoesByItsThreads) {
  BackendInfo info;
  info.name = "cpu";
  info.on_host = true;
  info.details["threads"] = "16";
  const Crossover many = crossover_of(info);
  info.details["threads"] = "2";
  const auto took = [&](const char* scene, uint64_t n) {
    const GridPlans plans = plan_grids(make_scene({.name = scene, .n = n}).positions);
    return chosen_method(info, n, plans, {.method = Method::automatic});
  };
  const Crossover few = crossover_of(info);
  EXPECT_EQ(took("one_cell", uint64_t(least_spheres) - 1), Method::parallel);
  EXPECT_EQ(took("one_cell", uint64_t(least_spheres)), Method::collide_grid);
  EXPECT_EQ(took("one_cell", 8000), Method::collide_grid);
  EXPECT_EQ(took("uniform", uint64_t(few.grid_from * 0.6)), Method::parallel);  // 0.6 others in a cell
  EXPECT_EQ(took("uniform", uint64_t(few.grid_from)), Method::collide_grid);
  EXPECT_GT(many.hashed_from, few.hashed_from);
  info.details["threads"] = "16";
  EXPECT_EQ(took("uniform", uint64_t(many.grid_from * 0.6)), Method::parallel);
  EXPECT_EQ(took("uniform", uint64_t(many.grid_from)), Method::collide_grid);
  EXPECT_EQ(took("one_cell", uint64_t(least_spheres)), Method::collide_grid);
}

TEST(MethodsOnTheHost, OnlyAutoChoosesItsGroups) {
  BackendInfo info;
  info.name = "cuda";
  const uint64_t many = crossover_of(info).wide_from, few = crossover_of(info).narrow_to;
  const auto block = [&](uint64_t n, CollideOptions options) {
    return chosen_block(info, n, Method::collide_grid, options);
  };
  EXPECT_EQ(block(many, {.method = Method::automatic}), wide_block);
  EXPECT_EQ(block(many - 1, {.method = Method::automatic}), CollideOptions{}.block);
  EXPECT_EQ(block(many, {.method = Method::automatic, .block = 64}), 64u);
  EXPECT_EQ(block(many, {.method = Method::collide_grid}), CollideOptions{}.block);
  const auto square = [&](uint64_t n, CollideOptions options) {
    return chosen_block(info, n, Method::collide_square, options);
  };
  EXPECT_EQ(square(few, {.method = Method::automatic}), narrow_block);
  EXPECT_EQ(square(few + 1, {.method = Method::automatic}), square_block);
  EXPECT_EQ(square(few, {.method = Method::automatic, .block = 256}), 256u);
  EXPECT_EQ(square(few, {.method = Method::collide_square}), CollideOptions{}.block);
  EXPECT_EQ(chosen_block(info, few, Method::collide_triangle, {.method = Method::automatic}), CollideOptions{}.block);
}

}  // namespace
}  // namespace spherepair
