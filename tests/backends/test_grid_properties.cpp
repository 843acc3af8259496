// SPDX-License-Identifier: MIT
// The grid of every backend on spheres drawn at random: what must not change the set does not.
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/support/grid_results.h"

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

class GridProperties : public KernelTest {
 protected:
  // On the CPU RapidCheck tries all of its cases; elsewhere, where each takes 50 ms in software, some.
  bool tried_enough() { return !backend().info().on_host && ++tried_ > (full_stress() ? 1000 : 100); }

  std::vector<Pair> grid_pairs(const std::vector<vec4>& spheres, Cells cells) {
    backend().upload(scene_of(spheres));
    return *run_step(backend(), {.method = Method::collide_grid, .want_pairs = true, .grid = {.cells = cells}}).pairs;
  }

 private:
  int tried_ = 0;
};

TEST_P(GridProperties, PermutationGivesTheSameSet) {
  EXPECT_TRUE(rc::check("the order of the spheres does not matter", [this] {
    if (tried_enough()) return;
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

TEST_P(GridProperties, TranslationAndPowersOfTwoGiveTheSameSet) {
  EXPECT_TRUE(rc::check("neither the origin nor the unit matters", [this] {
    if (tried_enough()) return;
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

INSTANTIATE_BACKENDS(GridProperties);

}  // namespace
}  // namespace spherepair
