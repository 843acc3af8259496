// SPDX-License-Identifier: MIT
// The grid of the CPU, which judges the other backends at sizes that brute force cannot reach: its set equals that of
// all pairs on every kind of scene, cells, radii, instruction set and number of threads.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <set>

#include "api/open.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

void expect_grid(const Scene& scene, const std::string& what) {
  EXPECT_EQ(first_grid_mismatch(scene), "") << what << ", " << scene.size() << " spheres";
}

TEST(CpuGrid, EqualsAllPairsOnEveryScene) {
  for (const SceneKind& kind : scene_kinds())
    for (uint64_t n : {0, 1, 2, 3, 100, by_form(2000, 500)})
      for (float ratio : {1.0f, 3.0f, 1000.0f, 1e5f})
        expect_grid(make_scene({.name = kind.name, .n = n, .radius = 0.5f / ratio, .radius_ratio = ratio}),
                    fmt::format("{}, radius ratio {}", kind.name, ratio));
}

TEST(CpuGrid, FarFromTheOriginAndBelowZero) {
  for (const SceneKind& kind : scene_kinds())
    for (float offset : {-3.0f, -1e3f, 1e5f, -1e7f, 1e9f})
      for (float ratio : {1.0f, 300.0f})
        expect_grid(make_scene({.name = kind.name, .n = 260, .radius_ratio = ratio, .offset = offset}),
                    fmt::format("{}, offset {}, radius ratio {}", kind.name, offset, ratio));
}

// Few large spheres among many small ones: most levels are sparse, and neighbours are levels apart.
TEST(CpuGrid, RadiiAcrossFiveDecades) {
  for (double fraction : {1e-3, 1e-6, 1e-9, 1e-12})
    for (const char* kind : {"uniform", "clustered"}) {
      SceneOptions options = {.name = kind, .n = by_form(2000u, 600u), .radius = 0x1p-10f, .radius_ratio = 1e5f};
      options.packing_fraction = fraction;
      Scene scene = make_scene(options);
      expect_grid(scene, fmt::format("{} at {}", kind, fraction));
      for (size_t i = 0; i < scene.size(); i += 7) scene.positions[i].w = i % 2 ? 0 : 0x1p-149f;
      expect_grid(scene, fmt::format("{} at {} with radii of 0", kind, fraction));
    }
}

TEST(CpuGrid, OneSphereFarAway) {
  for (float ratio : {1.0f, 3.0f, 1000.0f})
    for (vec4 far : {vec4{1e9f, 0, 0, 0.5f}, vec4{-1e9f, 1e9f, 3e38f, 0.5f}, vec4{0, -3e38f, 0, 0.5f}}) {
      Scene scene = make_scene({.name = "uniform", .n = 1500, .radius_ratio = ratio});
      scene.positions[1234] = far;
      expect_grid(scene, fmt::format("radius ratio {}, one at ({}, {}, {})", ratio, far.x, far.y, far.z));
    }
}

TEST(CpuGrid, HugeAndTinyNumbers) {
  for (int exponent : {-140, -120, -100, -80, -40, 60, 95, 110, 120}) {
    Scene scene = make_scene({.name = "uniform", .n = 400, .radius_ratio = exponent % 20 ? 1.0f : 50.0f});
    for (vec4& s : scene.positions)
      s = {std::ldexp(s.x, exponent), std::ldexp(s.y, exponent), std::ldexp(s.z, exponent), std::ldexp(s.w, exponent)};
    expect_grid(scene, fmt::format("times 2^{}", exponent));
  }
}

float next_to(float x, uint64_t choice) {
  if (choice % 3 == 0) return x == 0 && choice % 2 ? -0.0f : x;
  return std::nextafter(x, choice % 3 == 1 ? -INFINITY : INFINITY);
}

// Centres on and next to the borders of cells, whose sides are near the diameter: signed zeros among them.
TEST(CpuGrid, CentresOnBordersOfCells) {
  std::mt19937_64 random(20251121);
  for (float side : {1.0f, 1.00390625f, 0.3f})
    for (float low : {0.0f, -4.0f}) {
      std::vector<vec4> spheres;
      for (int i = 0; i < 1500; ++i) {
        const auto coordinate = [&] { return next_to(low + float(random() % 8) * side, random()); };
        spheres.push_back({coordinate(), coordinate(), coordinate(), side / 2});
      }
      Scene scene = scene_of(spheres);
      expect_grid(scene, fmt::format("cells of {} from {} on", side, low));
      for (vec4& s : scene.positions) s.w *= float(1 + random() % 3) / 3;
      scene.equal_radii = false;
      expect_grid(scene, fmt::format("cells of {} from {} on, three radii", side, low));
    }
}

// Long rows, flat layers and single columns of cells.
TEST(CpuGrid, LinesAndPlanes) {
  for (int flat = 1; flat < 7; ++flat) {
    Scene scene = make_scene({.name = "uniform", .n = 4000});
    for (vec4& s : scene.positions) {
      if (flat & 1) s.x = 0.25f;
      if (flat & 2) s.y = -1;
      if (flat & 4) s.z = 7;
      s.x *= 20, s.y *= 20, s.z *= 20;
    }
    expect_grid(scene, fmt::format("flat along axes {:03b}", flat));
  }
}

// A row of cells that is longer than the table comes back to its own slots: clusters lie a little less, or more, than
// the table's 1024 cells from each other.
TEST(CpuGrid, RowsLongerThanTheTable) {
  std::mt19937_64 random(20251121);
  const auto unit = [&] { return float(random() % 1024) / 1024; };
  for (float gap : {1018.0f, 1020.0f, 1024.0f, 1026.0f}) {
    std::vector<vec4> spheres;
    for (int i = 0; i < 600; ++i) spheres.push_back({float(i % 20) * gap + 4 * unit(), unit(), unit(), 0.5f});
    expect_grid(scene_of(spheres), fmt::format("clusters {} m apart", gap));
  }
}

// Beyond 2^30 cells all spheres share the last one, however far apart they are.
TEST(CpuGrid, SpheresBeyondTheLastCellAreFoundWithoutWalkingTheWayBetweenThem) {
  std::mt19937_64 random(20251121);
  for (const int axis : {0, 1, 2}) {
    std::vector<vec4> spheres;
    for (int i = 0; i < 300; ++i) {
      const float places[] = {0, 0, 0, 0, 1e7f, 1.2e7f, 1.5e7f}, far = places[i % 7] + float(random() % 8);
      vec4 sphere = {0.25f, 0.25f, 0.25f, random() % 2 ? 0.5f : 0x1p-10f};
      (axis == 0 ? sphere.x : axis == 1 ? sphere.y : sphere.z) = far;
      spheres.push_back(sphere);
    }
    expect_grid(scene_of(spheres), fmt::format("far along axis {}", axis));
  }
}

TEST(CpuGrid, EveryNumberOfThreadsGivesTheSame) {
  for (const char* kind : {"uniform", "clustered", "one_cell"}) {
    const Scene scene = make_scene({.name = kind, .n = kind == std::string("one_cell") ? 600u : 60000u});
    for (Cells cells : both_cells) {
      CpuGrid grid;
      const StepResult one = result_of(grid, scene, cells, true, 1);
      for (const int threads : {2, 3, 8}) {
        const StepResult other = result_of(grid, scene, cells, true, threads);
        EXPECT_TRUE(other.totals.fingerprint == one.totals.fingerprint && other.counts == one.counts &&
                    other.pairs == one.pairs && other.totals.deferred == one.totals.deferred)
            << kind << ", " << name_of(cells) << ", " << threads << " threads";
      }
    }
  }
}

// One grid, many scenes: nothing is left from the scene before. Kept cells give what new ones give.
TEST(CpuGrid, KeepsMemoryAndCellsButNoAnswers) {
  CpuGrid grid;
  for (uint64_t n : {20000, 0, 300, 5000, 1, 40000})
    for (Cells cells : both_cells) {
      const Scene scene = make_scene({.name = "uniform", .n = n, .radius_ratio = n == 300 ? 100.0f : 1.0f});
      const PairsFound wanted = search_parallel(search_of(scene, true, 2));
      EXPECT_EQ(difference(result_of(grid, scene, cells, true), wanted), "") << n << ", " << name_of(cells);
      const PairsFound kept = grid.search(search_of(scene, true, 2), plan_grid(scene, cells), true);
      EXPECT_EQ(difference({kept.totals, grid.counts(2), kept.list}, wanted), "") << n << " kept, " << name_of(cells);
    }
}

TEST(CpuGrid, FollowsMovesOutOfItsCells) {
  const auto backend = open_backend("cpu");
  Scene scene = make_scene({.name = "random", .n = 3000});
  for (vec4& v : scene.velocities) v = {v.y, v.y * 3, -v.y, 0};
  backend->upload(scene);
  for (int step = 0; step < 60; ++step) {
    backend->move();
    CollideOptions options = {.method = Method::collide_grid, .want_pairs = step % 2 == 0};
    options.grid.cells = step % 3 ? Cells::dense : Cells::hashed;
    const StepResult grid = run_step(*backend, options), again = run_step(*backend, options);
    const StepResult all = run_step(*backend, {.method = Method::parallel, .want_pairs = options.want_pairs});
    ASSERT_TRUE(grid.totals.fingerprint == all.totals.fingerprint && grid.counts == all.counts &&
                grid.pairs == all.pairs && again.counts == all.counts)
        << "step " << step;
  }
}

std::set<std::string> threads_of_this_process() {
  std::set<std::string> threads;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task"))
    threads.insert(thread.path().filename().string());
  return threads;
}

// To end and start threads takes longer than a step of few spheres. A GPU's driver may end one of its own meanwhile.
TEST(CpuGrid, EveryStepIsTakenByTheSameThreads) {
  if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "this system does not list a process's threads";
  const auto backend = open_backend("cpu", {.threads = 7});
  backend->upload(make_scene({.name = "uniform", .n = 9000, .radius_ratio = 16, .packing_fraction = 0.01}));
  std::set<std::string> threads;
  for (int step = 0; step < 3; ++step) {
    backend->move();
    run_step(*backend, {.method = Method::collide_grid, .want_pairs = true});
    const std::set<std::string> now = threads_of_this_process();
    if (step > 0) {
      EXPECT_TRUE(std::ranges::includes(threads, now)) << "step " << step << " started threads";
    }
    threads = now;
  }
  EXPECT_GE(threads.size(), 7u);
}

struct PeerCount {
  uint64_t n;
  double fraction;
  uint64_t pairs;
};

// Counts of the same scene that other programs publish.
TEST(CpuGrid, CountsOfOtherPrograms) {
  std::vector<PeerCount> known = {{1024, 0.3, 1192},
                                  {16384, 0.3, 19081},
                                  {16384, 0.05, 3206},
                                  {1'000'000, 0.3, 1'188'389},
                                  {1'000'000, 0.05, 198'211}};
  if (full_stress()) known.insert(known.end(), {{10'000'000, 0.3, 11'949'965}, {10'000'000, 0.05, 1'997'975}});
  CpuGrid grid;
  for (const PeerCount& peer : known) {
    SceneOptions options = {.name = "uniform", .n = peer.n};
    options.packing_fraction = peer.fraction;
    const Scene scene = make_scene(options);
    const SearchInput search = search_of(scene, true, 2);
    const PairsFound dense = grid.search(search, plan_grid(scene, Cells::dense), false);
    const PairsFound hashed = grid.search(search, plan_grid(scene, Cells::hashed), false);
    EXPECT_EQ(dense.totals.pairs, peer.pairs) << peer.n << " at " << peer.fraction;
    EXPECT_EQ(fingerprint(dense.list), dense.totals.fingerprint) << peer.n << " at " << peer.fraction;
    EXPECT_EQ(first_difference(dense.list, hashed.list).has_value(), false) << peer.n << " at " << peer.fraction;
  }
}

}  // namespace
}  // namespace spherepair
