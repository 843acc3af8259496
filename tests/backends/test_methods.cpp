// SPDX-License-Identifier: MIT
// Every method, group size and kind of scene: counts, flags, totals, fingerprint and pairs equal the oracle's.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/backend/method_choice.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

// Equal radii and a ratio of 1000, at a number of spheres that no group size divides; kinds that fix the radii refuse
// the ratio.
std::vector<Scene> scenes_of_kind(const std::string& kind, uint64_t n) {
  std::vector<Scene> scenes;
  for (float ratio : {1.0f, 1000.0f}) {
    const float radius = ratio == 1.0f ? 0.5f : 0.01f;
    try {
      scenes.push_back(make_scene({.name = kind, .n = n, .radius = radius, .radius_ratio = ratio}));
    } catch (const std::invalid_argument&) {
      if (ratio == 1.0f) throw;
    }
  }
  return scenes;
}

// The naive test may be wrong where rounding decides: only where S and Q differ by a few units in the last place.
bool within_rounding(const vec4& a, const vec4& b) {
  const auto square = [](long double x) { return x * x; };
  const long double s =
      square((long double)(a.x) - b.x) + square((long double)(a.y) - b.y) + square((long double)(a.z) - b.z);
  const long double q = square((long double)(a.w) + b.w);
  return std::abs(s - q) <= 16 * 0x1p-24L * std::max(s, q);
}

// A naive answer must be free of contradictions and equal the exact one but for pairs within rounding.
void expect_naive(Backend& backend, const Scene& scene, std::span<const Pair> expected, CollideOptions options) {
  options.exact = false;
  options.want_pairs = true;
  const StepResult answer = run_step(backend, options);
  const std::string where = fmt::format("{}, scene {}, {}", backend.info().name, scene.name, describe(options));
  EXPECT_EQ(first_mismatch(answer, *answer.pairs, scene.size()), "") << where;
  EXPECT_EQ(answer.totals.deferred, 0u) << where;
  std::vector<Pair> wrong;
  std::set_symmetric_difference(answer.pairs->begin(), answer.pairs->end(), expected.begin(), expected.end(),
                                std::back_inserter(wrong));
  for (const Pair& pair : wrong)
    EXPECT_TRUE(within_rounding(scene.positions[pair.first], scene.positions[pair.second]))
        << where << ", pair (" << pair.first << ", " << pair.second << ")";
}

class Methods : public BackendTest {};
class MethodsInKernels : public KernelTest {};

// The grid keeps its cells while spheres stand still, also when another method comes between.
TEST_P(Methods, OneAfterTheOther) {
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  const std::vector<Pair> expected = brute_force_pairs(scene.positions);
  backend().upload(scene);
  for (const Method method : {Method::collide_grid, fast_method(backend()).method, Method::collide_grid}) {
    const CollideOptions options = {.method = method, .want_pairs = true};
    EXPECT_EQ(first_mismatch(run_step(backend(), options), expected, scene.size()), "") << method_name(method);
  }
}

// In software one group size a scene, by turns.
TEST_P(MethodsInKernels, OfEverySceneEqualTheOracle) {
  const size_t sizes = by_form(backend(), block_sizes().size(), size_t(1));
  uint64_t n = 250;
  size_t first = 0;
  for (const SceneKind& kind : scene_kinds()) {
    n += 23;
    for (const Scene& scene : scenes_of_kind(kind.name, n)) {
      const auto blocks = block_sizes().subspan(first, sizes);
      expect_pairs(backend(), scene, brute_force_pairs(scene.positions), every_method(backend(), blocks));
      first = (first + sizes) % block_sizes().size();
    }
  }
}

// The paper's arrangements of 8 or 16 spheres a group.
TEST_P(Methods, SmallGroupsAreOfTheTiledKernelOnly) {
  const Scene scene = make_scene({.name = "aligned", .n = 128, .groups = 8, .group_size = 16});
  std::vector<CollideOptions> tiled;
  for (const uint block : small_block_sizes()) tiled.push_back({.method = Method::collide_tiled, .block = block});
  expect_pairs(backend(), scene, brute_force_pairs(scene.positions), tiled);
  if (backend().info().on_host) return;  // takes every method and group size
  for (const Method method : device_methods()) {
    if (method == Method::collide_tiled) continue;
    EXPECT_THROW(backend().collide({.method = method, .block = 8}), std::invalid_argument) << method_name(method);
  }
}

TEST_P(MethodsInKernels, NaiveIsWrongOnlyWithinRounding) {
  for (const SceneKind& kind : scene_kinds())
    for (const Scene& scene : scenes_of_kind(kind.name, 259)) {
      const std::vector<Pair> expected = brute_force_pairs(scene.positions);
      backend().upload(scene);
      for (const CollideOptions& options : every_method(backend(), block_sizes().subspan(1, by_form(backend(), 2, 1))))
        expect_naive(backend(), scene,
                     options.method == Method::collide_group ? within_groups(expected, options.block) : expected,
                     options);
    }
}

// The number of spheres that a group of collide_triangle tests affects only its speed.
TEST_P(MethodsInKernels, ColumnsNeverChangeTheSet) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU has no groups";
  std::vector<CollideOptions> methods;
  for (uint block : {32u, 256u})
    for (uint columns : {1u, 7u, 100u, 1024u, ~0u}) methods.push_back({.block = block, .columns = columns});
  for (const uint64_t n : {200, 257, by_form(backend(), 4100, 1281)})  // 1 to 17 groups of 256 rows
    for (const float radius_ratio : {1.0f, 3.0f}) {
      if (radius_ratio > 1 && n != 257) continue;
      SCOPED_TRACE(fmt::format("{} spheres, radii 1 to {}", n, radius_ratio));
      SceneOptions options = {.name = "uniform", .n = n, .radius_ratio = radius_ratio};
      options.packing_fraction = 0.1;
      const Scene scene = make_scene(options);
      expect_pairs(backend(), scene, brute_force_pairs(scene.positions), methods);
    }
}

// The answers of one step may not leak into the next, nor those of a larger scene into a smaller.
TEST_P(Methods, NothingIsLeftFromTheStepBefore) {
  for (uint64_t n : {2000, 150, 1100}) {
    const Scene scene = make_scene({.name = "clustered", .n = n});
    expect_pairs(backend(), scene, brute_force_pairs(scene.positions), every_method(backend(), block_sizes().first(1)));
  }
}

TEST_P(MethodsInKernels, RightAfterEveryMove) {
  const Scene scene = make_scene({.name = "random", .n = 700});
  backend().upload(scene);
  const std::vector<CollideOptions> methods = every_method(backend(), block_sizes().subspan(3, 1));
  for (size_t step = 0; step < 21; ++step) {
    backend().move();
    CollideOptions options = methods[step % methods.size()];
    options.want_pairs = step % 3 == 0;
    const StepResult answer = run_step(backend(), options);
    const std::vector<Pair> expected = brute_force_pairs(current_state(backend()).positions);
    const std::vector<Pair> wanted =
        options.method == Method::collide_group ? within_groups(expected, options.block) : expected;
    EXPECT_EQ(first_mismatch(answer, wanted, scene.size()), "") << describe(options) << ", step " << step;
  }
}

TEST_P(Methods, EveryLaunchIsTimedUnderItsKernelsName) {
  const BackendInfo& info = backend().info();
  std::vector<std::string> expected = {"move", "parallel"};
  if (!info.on_host) expected = {"empty", "move", "collide_triangle", "tally"};
  if (!info.on_host && !info.device_timers) GTEST_SKIP() << "this device has no timers";
  backend().upload(make_scene({.name = "random", .n = 300}));
  backend().time_stages(true);
  backend().launch_empty(10);
  backend().move();
  backend().collide(fast_method(backend()));
  std::vector<std::string> stages;
  double seconds = 0;
  for (const StageTime& time : backend().stage_times()) {
    stages.push_back(time.stage);
    seconds += time.seconds;
  }
  backend().time_stages(false);
  EXPECT_EQ(stages, expected);
  EXPECT_GT(seconds, 0);
  EXPECT_LT(seconds, 10) << "of 300 spheres: not seconds";
  EXPECT_TRUE(backend().stage_times().empty()) << "each time is returned once";
}

TEST_P(Methods, AutomaticIsRightWhateverItTakes) {
  const Crossover& row = crossover_of(backend().info());
  const auto many = uint64_t(std::max(grid_from(row, 0.4, 0), grid_from(row, 0.8, 0))) + 50;  // of a gas, with room
  const auto took = [&](const SceneOptions& options) {
    const Scene scene = make_scene(options);
    expect_pairs(backend(), scene, swept_pairs(scene.positions), {{.method = Method::automatic}});
    return backend().choice({.method = Method::automatic});
  };
  for (const char* scene : {"uniform", "clustered", "random"})
    for (const uint64_t n : {2, 300, 4000}) took({.name = scene, .n = n});
  EXPECT_NE(took({.name = "uniform", .n = uint64_t(row.grid_from / 2)}).method, Method::collide_grid);
  EXPECT_EQ(took({.name = "uniform", .n = many}).method, Method::collide_grid);
  const uint64_t in_one_cell = backend().info().software ? 700 : 4000;
  const MethodChoice one_cell = took({.name = "one_cell", .n = in_one_cell});
  EXPECT_EQ(one_cell.method == Method::collide_grid, backend().info().on_host) << describe(one_cell);
  const MethodChoice far = took({.name = "uniform", .n = many, .offset = 1e5f});
  EXPECT_EQ(far.method, Method::collide_grid);
  EXPECT_NE(far.reason.find(fmt::format("{} spheres", many)), std::string::npos) << far.reason;
}

INSTANTIATE_BACKENDS(Methods);
INSTANTIATE_BACKENDS(MethodsInKernels);

}  // namespace
}  // namespace spherepair
