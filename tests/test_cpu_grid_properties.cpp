// SPDX-License-Identifier: MIT
// The grid of the CPU on spheres drawn at random: what must not change the set does not, and all pairs give the same.
#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

#include "grid_answers.h"

namespace spherepair {
namespace {

// Spheres of a small lattice: ties are common, and translated or scaled they stay exact.
rc::Gen<std::vector<vec4>> lattice_spheres() {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-40, 41), [](int k) { return float(k) / 8; });
  const auto radius = rc::gen::map(rc::gen::inRange(0, 9), [](int k) { return float(k) / 8; });
  const auto sphere = rc::gen::apply(
      [](float x, float y, float z, float r) {
        return vec4{x, y, z, r};
      },
      coordinate, coordinate, coordinate, radius);
  return rc::gen::container<std::vector<vec4>>(sphere);
}

std::vector<Pair> grid_pairs(const std::vector<vec4>& spheres, Cells cells) {
  static CpuGrid grid;
  return *answer_of(grid, scene_of(spheres), cells, true, 1).pairs;
}

TEST(CpuGrid, PermutationGivesTheSameSet) {
  EXPECT_TRUE(rc::check("the order of the spheres does not matter", [] {
    const std::vector<vec4> spheres = *lattice_spheres();
    std::vector<uint> order(spheres.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), std::mt19937_64(*rc::gen::arbitrary<uint64_t>()));
    std::vector<vec4> shuffled;
    for (uint i : order) shuffled.push_back(spheres[i]);
    for (Cells cells : both_cells) {
      std::vector<Pair> pairs = grid_pairs(shuffled, cells);
      for (Pair& pair : pairs) {
        const auto [low, high] = std::minmax(order[pair.first], order[pair.second]);
        pair = {low, high};
      }
      std::ranges::sort(pairs);
      RC_ASSERT(pairs == grid_pairs(spheres, cells));
    }
  }));
}

TEST(CpuGrid, TranslationAndPowersOfTwoGiveTheSameSet) {
  EXPECT_TRUE(rc::check("neither the origin nor the unit matters", [] {
    const std::vector<vec4> spheres = *lattice_spheres();
    const float x = float(*rc::gen::inRange(-100000, 100000)), y = float(*rc::gen::inRange(-99, 100)) / 8;
    const int power = *rc::gen::inRange(-130, 110);
    std::vector<vec4> moved, scaled;
    for (const vec4& s : spheres) {
      moved.push_back({s.x + x, s.y + y, s.z - x, s.w});
      scaled.push_back(
          {std::ldexp(s.x, power), std::ldexp(s.y, power), std::ldexp(s.z, power), std::ldexp(s.w, power)});
    }
    for (Cells cells : both_cells) {
      const std::vector<Pair> pairs = grid_pairs(spheres, cells);
      RC_ASSERT(pairs == grid_pairs(moved, cells));
      RC_ASSERT(pairs == grid_pairs(scaled, cells));
    }
  }));
}

SceneOptions drawn_scene(uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto& kinds = scene_kinds();
  const auto log_uniform = [&](double low, double high) {
    return low * std::pow(high / low, double(random() >> 11) * 0x1p-53);
  };
  SceneOptions options = {
      .name = kinds[random() % kinds.size()].name, .n = uint64_t(log_uniform(1, 4000)), .seed = seed};
  options.radius = float(log_uniform(1e-3, 2));
  if (random() % 2) options.radius_ratio = float(log_uniform(1, 1e5));
  options.packing_fraction = random() % 2 ? log_uniform(1e-12, 0.7) : 0.3;
  if (random() % 3 == 0) options.offset = float(log_uniform(1, 1e8)) * (random() % 2 ? 1.0f : -1.0f);
  return options;
}

// SOAK_SECONDS in the environment makes it longer; SOAK_SEED starts it elsewhere.
TEST(CpuGrid, Soak) {
  const char *seconds = std::getenv("SOAK_SECONDS"), *start = std::getenv("SOAK_SEED");
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds ? std::atof(seconds) : 5);
  uint64_t seed = start ? std::strtoull(start, nullptr, 10) : 1;
  const uint64_t first = seed;
  for (; std::chrono::steady_clock::now() < end; ++seed) {
    const SceneOptions options = drawn_scene(seed);
    ASSERT_EQ(objection_to_grid(make_scene(options)), "")
        << "SOAK_SEED=" << seed << ": " << options.name << " of " << options.n;
  }
  fmt::print("{} scenes from SOAK_SEED={} on\n", seed - first, first);
}

}  // namespace
}  // namespace spherepair
