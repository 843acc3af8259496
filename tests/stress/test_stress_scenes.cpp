// SPDX-License-Identifier: MIT
// Rows 9 to 20 of the stress catalogue: the collision sets of whole scenes, against the oracle.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <thread>

#include "api/open.h"
#include "tests/oracle/adversarial.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"
#include "tests/support/catalogue.h"

namespace spherepair {
namespace {

std::vector<CollideOptions> all_methods(const Backend& backend) { return every_method(backend, block_sizes()); }
std::vector<CollideOptions> each_method_once(const Backend& backend) {
  return every_method(backend, block_sizes().subspan(2, 1));
}

// m^3 spheres of radius 1/2 on a cubic lattice; the sum is rounded to float once.
std::vector<vec4> cubic_lattice(int m, double spacing, float offset) {
  std::vector<vec4> spheres;
  for (int i = 0; i < m * m * m; ++i) {
    const auto coordinate = [&](int k) { return float(k * spacing + double(offset)); };
    spheres.push_back({coordinate(i % m), coordinate(i / m % m), coordinate(i / (m * m)), 0.5f});
  }
  return spheres;
}

uint64_t count_ties(const std::vector<vec4>& spheres) {
  uint64_t ties = 0;
  for (size_t i = 0; i < spheres.size(); ++i)
    for (size_t j = i + 1; j < spheres.size(); ++j) ties += relation(spheres[i], spheres[j]) == Relation::tangent;
  return ties;
}

std::vector<vec4> uniform_spheres(uint64_t n, double fraction) {
  return make_scene({.name = "uniform", .n = n, .packing_fraction = fraction}).positions;
}

template <typename Change>
std::vector<vec4> changed(std::vector<vec4> spheres, const Change& change) {
  for (vec4& sphere : spheres) sphere = change(sphere);
  return spheres;
}

// Where a sphere of the shuffled order stood before.
std::vector<uint> permutation(size_t n, uint64_t seed) {
  std::vector<uint> order(n);
  std::iota(order.begin(), order.end(), 0u);
  Random random(seed);
  for (size_t k = n; k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
  return order;
}

template <typename Item>
std::vector<Item> permuted(const std::vector<Item>& items, const std::vector<uint>& order) {
  std::vector<Item> result;
  for (uint from : order) result.push_back(items[from]);
  return result;
}

std::vector<Pair> by_old_index(std::vector<Pair> pairs, const std::vector<uint>& order) {
  for (Pair& pair : pairs) {
    const uint i = order[pair.first], j = order[pair.second];
    pair = {std::min(i, j), std::max(i, j)};
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST_P(StressCatalogue, Row09_CubicLatticeTangent) {
  constexpr int m = 9;
  const std::vector<vec4> exact = cubic_lattice(m, 1, 0);
  EXPECT_EQ(count_ties(exact), 3u * m * m * (m - 1));
  expect_pairs(backend(), scene_of(exact), {}, all_methods(backend()));
  for (float offset : {0.1f, 1e5f}) {
    const std::vector<vec4> spheres = cubic_lattice(m, 1, offset);
    expect_pairs(backend(), scene_of(spheres), brute_force_pairs(spheres), each_method_once(backend()));
  }
}

TEST_P(StressCatalogue, Row10_LatticeOverlappingByOneUlp) {
  constexpr double spacing = 1 - 0x1p-24;
  std::vector<vec4> couples;
  std::vector<Pair> expected;
  for (int k = 0; k < 350; ++k) {
    const float y = float(3 * (k % 19)), z = float(3 * (k / 19));
    const bool far_first = k % 2 == 0;
    couples.push_back({far_first ? float(spacing) : 0.0f, y, z, 0.5f});
    couples.push_back({far_first ? 0.0f : -float(spacing), y, z, 0.5f});
    expected.push_back({uint(2 * k), uint(2 * k + 1)});
  }
  expect_pairs(backend(), scene_of(couples), expected, all_methods(backend()));
  const std::vector<vec4> lattice = cubic_lattice(9, spacing, 0);
  const std::vector<Pair> pairs = brute_force_pairs(lattice);
  EXPECT_GT(pairs.size(), 500u);
  expect_pairs(backend(), scene_of(lattice), pairs, each_method_once(backend()));
}

TEST_P(StressCatalogue, Row11_AllAtOnePoint) {
  const uint n = by_form(backend(), 1001u, 501u);
  std::vector<Pair> expected;
  for (uint i = 0; i < n; ++i)
    for (uint j = i + 1; j < n; ++j) expected.push_back({i, j});
  for (const vec4& sphere : {vec4{0, 0, 0, 0.5f}, vec4{1e5f, -0.1f, 3e7f, 0.5f}, vec4{0, 0, 0, 0x1p-149f}})
    expect_pairs(backend(), scene_of(std::vector<vec4>(n, sphere)), expected, each_method_once(backend()));
  const std::vector<vec4> points(n, vec4{1, 2, 3, 0});
  expect_pairs(backend(), scene_of(points), {}, each_method_once(backend()));
}

TEST_P(StressCatalogue, Row15_FilterDecidesDensePackings) {
  const bool cpu = backend().info().on_host;
  const uint64_t n = by_form(backend(), 100'000, 4000);
  if (n < 100'000) fmt::print("{}: n = {} instead of 100000 in the short form\n", backend().info().name, n);
  for (double fraction : {0.3, 0.5, 0.64}) {
    const std::vector<vec4> spheres = uniform_spheres(n, fraction);
    const std::vector<Pair> expected = swept_pairs(spheres);
    double most = 0;
    backend().upload(scene_of(spheres));
    for (CollideOptions options : cpu ? std::vector{fast_method(backend())} : each_method_once(backend())) {
      if (options.method == Method::collide_group) continue;
      options.want_pairs = true;
      const StepResult answer = run_step(backend(), options);
      const double undecided = double(answer.totals.deferred) / (0.5 * double(n) * double(n - 1));
      most = std::max(most, undecided);
      EXPECT_EQ(first_mismatch(answer, expected, n), "") << describe(options) << ", packing fraction " << fraction;
      EXPECT_LE(undecided, 1e-6) << describe(options) << ", packing fraction " << fraction;
    }
    note_figure(fmt::format("{:.0e} undecided at {}, n = {}", most, fraction, n));
  }
}

TEST_P(StressCatalogue, Row16_EighthLatticeMovedByIntegers) {
  Random random(16);
  std::vector<vec4> spheres;
  for (int k = 0; k < 600; ++k) {
    const auto eighths = [&](int low, int high) { return float(random.between(low, high)) / 8; };
    spheres.push_back({eighths(-14, 14), eighths(-14, 14), eighths(-14, 14), eighths(2, 6)});
  }
  const std::vector<Pair> expected = brute_force_pairs(spheres);
  EXPECT_GT(count_ties(spheres), 100u);
  for (int power = 0; power <= 20; power += 5) {
    const float x = std::ldexp(1.0f, power), y = -x + 7, z = x - 13;
    const auto move = [=](vec4 s) { return vec4{s.x + x, s.y + y, s.z + z, s.w}; };
    expect_pairs(backend(), scene_of(changed(spheres, move)), expected, each_method_once(backend()));
  }
}

TEST_P(StressCatalogue, Row17_FloatSceneFarFromOrigin) {
  const std::vector<vec4> spheres = uniform_spheres(1000, 0.3);
  const std::vector<Pair> at_origin = brute_force_pairs(spheres);
  for (float distance : {1e3f, 1e4f, 1e5f, 1e6f}) {
    const auto move = [=](vec4 s) { return vec4{s.x + distance, s.y + distance, s.z + distance, s.w}; };
    const std::vector<vec4> moved = changed(spheres, move);
    const std::vector<Pair> expected = brute_force_pairs(moved);
    expect_pairs(backend(), scene_of(moved), expected, each_method_once(backend()));
    std::vector<Pair> flips;
    std::set_symmetric_difference(at_origin.begin(), at_origin.end(), expected.begin(), expected.end(),
                                  std::back_inserter(flips));
    note_figure(fmt::format("{} of {} flip at {:.0e}", flips.size(), at_origin.size(), distance));
    fmt::print("moved by {:.0e}: {} of {} collisions flip by rounding the data\n", distance, flips.size(),
               at_origin.size());
  }
}

TEST_P(StressCatalogue, Row18_ShuffledInput) {
  const Scene scene = make_scene({.name = "random", .n = 777});
  const auto run = [&](const Scene& start) {
    backend().upload(start);
    for (int step = 0; step < 60; ++step) backend().move();
    return std::pair(run_step(backend(), {.method = fast_method(backend()).method, .want_pairs = true}),
                     current_state(backend()));
  };
  const auto [answer, state] = run(scene);
  EXPECT_GT(answer.pairs->size(), 100u);
  for (uint64_t seed = 0; seed < 10; ++seed) {
    const std::vector<uint> order = permutation(scene.size(), seed);
    Scene shuffled = scene;
    shuffled.positions = permuted(scene.positions, order);
    shuffled.velocities = permuted(scene.velocities, order);
    const auto [given, given_state] = run(shuffled);
    count_figure("answers");
    count_figure("states");
    EXPECT_EQ(by_old_index(*given.pairs, order), *answer.pairs);
    EXPECT_EQ(state_hash(given_state.positions, given_state.velocities),
              state_hash(permuted(state.positions, order), permuted(state.velocities, order)));
  }
}

TEST_P(StressCatalogue, Row19_GroupSizesAndThreadCounts) {
  const Scene scene = make_scene({.name = "random", .n = 700, .radius_ratio = 3});
  const std::vector<Pair> expected = brute_force_pairs(scene.positions);
  expect_pairs(backend(), scene, expected, all_methods(backend()));
  if (!backend().info().on_host) return;
  const int cores = int(std::max(1u, std::thread::hardware_concurrency()));
  std::set<uint64_t> hashes;
  for (int threads : std::set<int>{1, 2, 3, 7, cores}) {
    const auto cpu = open_backend("cpu", {.threads = threads});
    expect_pairs(*cpu, scene, expected, every_method(*cpu, block_sizes().first(1)));
    for (int step = 0; step < 100; ++step) cpu->move();
    const Motion::State state = current_state(*cpu);
    hashes.insert(state_hash(state.positions, state.velocities));
  }
  EXPECT_EQ(hashes.size(), 1u) << "the state depends on the number of threads";
}

TEST_P(StressCatalogue, Row20_AxesPermutedAndMirrored) {
  Random random(20);
  std::vector<vec4> spheres = uniform_spheres(500, 0.3);
  for (vec4& sphere : spheres)  // half of them on a lattice, where ties are common
    if (random.next() >> 63) sphere = {std::round(sphere.x), std::round(sphere.y), std::round(sphere.z), sphere.w};
  const std::vector<Pair> expected = brute_force_pairs(spheres);
  EXPECT_GT(count_ties(spheres), 10u);
  std::array<int, 3> axes = {0, 1, 2};
  do {
    for (int mirrors = 0; mirrors < 8; ++mirrors) {
      const auto turn = [&](vec4 s) {
        const float from[3] = {s.x, s.y, s.z};
        const auto along = [&](int c) { return mirrors >> c & 1 ? -from[axes[c]] : from[axes[c]]; };
        return vec4{along(0), along(1), along(2), s.w};
      };
      const std::vector<CollideOptions> method = {fast_method(backend())};
      expect_pairs(backend(), scene_of(changed(spheres, turn)), expected, method);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
}

}  // namespace
}  // namespace spherepair
