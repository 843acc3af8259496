// SPDX-License-Identifier: MIT
// Scenes: the same bits everywhere, the paper's counts, and clear errors.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "api/open.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

uint64_t hash_of(const Scene& scene) { return state_hash(scene.positions, scene.velocities); }

uint64_t colliding_spheres(const std::vector<Pair>& pairs) {
  std::set<uint> spheres;
  for (const Pair& pair : pairs) spheres.insert({pair.first, pair.second});
  return spheres.size();
}

// The message must name what it is about.
void expect_error(const std::function<void()>& act, const std::string& word) {
  try {
    act();
    ADD_FAILURE() << "no error about " << word;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

uint64_t paper_count(uint64_t n, uint64_t seed) {
  return colliding_spheres(swept_pairs(make_scene({.name = "random", .n = n, .seed = seed}).positions));
}

const std::map<uint64_t, std::pair<uint64_t, uint64_t>> paper_ranges = {
    {64, {0, 4}}, {128, {7, 15}}, {256, {20, 40}}, {512, {100, 159}}, {32768, {31000, 32768}}};

TEST(Scenes, CountsOfThePaper) {
  for (const auto& [n, range] : paper_ranges) {
    const uint64_t count = paper_count(n, SceneOptions().seed);
    EXPECT_GE(count, range.first) << n << " spheres";
    EXPECT_LE(count, range.second) << n << " spheres";
  }
}

// The default seed alone would prove little: the middle of many seeds must be the paper's too.
TEST(Scenes, MedianCountsOfThePaper) {
  for (const auto& [n, range] : paper_ranges) {
    std::vector<uint64_t> counts;
    for (uint64_t seed = 0; seed < (n > 1000 ? 5 : 101); ++seed) counts.push_back(paper_count(n, seed));
    std::sort(counts.begin(), counts.end());
    const uint64_t median = counts[counts.size() / 2];
    const auto inside = std::count_if(counts.begin(), counts.end(), [&range = range](uint64_t count) {
      return count >= range.first && count <= range.second;
    });
    fmt::print("{} spheres: median {} colliding, {} of {} seeds in the paper's range of {} to {}\n", n, median, inside,
               counts.size(), range.first, range.second);
    EXPECT_GE(median, range.first) << n << " spheres";
    EXPECT_LE(median, range.second) << n << " spheres";
  }
}

TEST(Scenes, CountsOfUniformScenes) {
  EXPECT_EQ(swept_pairs(make_scene({.name = "uniform", .n = 1024, .packing_fraction = 0.3}).positions).size(), 1192u);
  EXPECT_EQ(swept_pairs(make_scene({.name = "uniform", .n = 16384, .packing_fraction = 0.05}).positions).size(), 3206u);
}

TEST(Scenes, EveryKindAtEverySize) {
  for (const SceneKind& kind : scene_kinds()) {
    EXPECT_STRNE(kind.summary, "");
    for (uint64_t n : {0, 1, 2, 3, 7, 63, 64, 65, 1000}) {
      const Scene scene = make_scene({.name = kind.name, .n = n});
      EXPECT_EQ(scene.size(), n) << kind.name;
      EXPECT_EQ(scene.velocities.size(), n) << kind.name;
      const bool equal = std::ranges::all_of(scene.positions, [&](const vec4& sphere) {
        return float_bits(sphere.w) == float_bits(scene.positions.front().w);
      });
      EXPECT_EQ(scene.equal_radii, equal) << kind.name;
      EXPECT_NO_THROW(check_scene(scene)) << kind.name;
      EXPECT_EQ(hash_of(scene), hash_of(make_scene({.name = kind.name, .n = n}))) << kind.name;
    }
  }
}

// Bits of every kind, as made on one machine: any other machine and compiler must make them too. A change here is a
// change of every recorded result.
TEST(Scenes, SameBitsOnEveryMachine) {
  struct Golden {
    const char* kind;
    float ratio;
    uint64_t hash;
  };
  const std::vector<Golden> goldens = {{"random", 1, 0x381255e06cd29f8c},     {"random", 1000, 0x7f898363bd29c2e8},
                                       {"aligned", 1, 0x108f638d4976d4c8},    {"aligned", 1000, 0x17c663666fdf4b8d},
                                       {"uniform", 1, 0xdedbab2be1eb2f0d},    {"uniform", 1000, 0xcbec133dad9640ef},
                                       {"lattice", 1, 0xe399245641dd8e9c},    {"lattice", 1000, 0x76243f8c36f577d8},
                                       {"grazing", 1, 0x70bb57ccd7664057},    {"grazing", 1000, 0xc63d9a9da235ce62},
                                       {"clustered", 1, 0x674e3ca1727776fe},  {"clustered", 1000, 0xb5515ecf9f76a3b2},
                                       {"coincident", 1, 0xfda43e0478d47220}, {"coincident", 1000, 0x5582508d93c6cf1e},
                                       {"far", 1, 0x3f8206ec067e0f3b},        {"far", 1000, 0x2977d5cc4ac1ce83},
                                       {"one_cell", 1, 0xd605031cc1afd586},   {"one_cell", 1000, 0x52a4d8c2d2b60e69},
                                       {"gas", 1, 0x3fa2cbacb9dde61a},        {"gas", 1000, 0xc523fb3f3bc4751e},
                                       {"bed", 1, 0x2fd5dccde2e398ad},        {"bed", 1000, 0xf515a603d7de09dc},
                                       {"column", 1, 0xc4eb52346752da6c},     {"column", 1000, 0x5e20ab75fd3c3ec9},
                                       {"collide2", 1, 0xf48dd1dee29ecb40},   {"collide2", 1000, 0x838d1686f3e9092e},
                                       {"newton", 1, 0x015ab31bc4389bb5},     {"newton", 1000, 0x9fddb859797fe70e}};
  EXPECT_EQ(goldens.size(), 2 * scene_kinds().size()) << "every kind has its hashes here";
  for (const Golden& golden : goldens) {
    const uint64_t hash = hash_of(make_scene({.name = golden.kind, .n = 1000, .radius_ratio = golden.ratio}));
    EXPECT_EQ(hash, golden.hash) << fmt::format("{}, radius ratio {}: {:#018x}", golden.kind, golden.ratio, hash);
  }
}

TEST(Scenes, PaperStart) {
  const Scene scene = make_scene({.name = "random", .n = 5000});
  std::set<float> speeds;
  for (size_t i = 0; i < scene.size(); ++i) {
    const vec4 p = scene.positions[i], v = scene.velocities[i];
    EXPECT_EQ(v.x, 0);
    EXPECT_EQ(v.z, 0);
    EXPECT_EQ(p.w, 0.5f);
    EXPECT_FALSE(p.y - p.w < scene.plane) << "sphere " << i << " starts below the plane";
    speeds.insert(v.y);
  }
  EXPECT_GT(speeds.size(), 4000u);
  EXPECT_EQ(scene.plane, -5);
}

TEST(Scenes, SeedsDiffer) {
  std::set<uint64_t> hashes;
  for (uint64_t seed = 0; seed < 20; ++seed) hashes.insert(hash_of(make_scene({.n = 500, .seed = seed})));
  EXPECT_EQ(hashes.size(), 20u);
}

TEST(Scenes, EveryArrangementOfThePaper) {
  for (auto [groups, size] : {std::pair(8u, 16u),
                              {16u, 8u},
                              {8u, 32u},
                              {16u, 16u},
                              {32u, 8u},
                              {8u, 64u},
                              {16u, 32u},
                              {32u, 16u},
                              {64u, 8u}}) {
    SceneOptions options = {.name = "aligned", .n = groups * size, .groups = groups, .group_size = size};
    EXPECT_EQ(make_scene(options).size(), groups * size);
    options.n = groups * size + 1;
    expect_error([&] { make_scene(options); }, "group");
  }
}

TEST(Scenes, RadiiSpanTheRatio) {
  const Scene scene = make_scene({.name = "uniform", .n = 4000, .radius = 0.01f, .radius_ratio = 1000});
  EXPECT_FALSE(scene.equal_radii);
  const auto [low, high] = std::minmax_element(scene.positions.begin(), scene.positions.end(),
                                               [](const vec4& a, const vec4& b) { return a.w < b.w; });
  EXPECT_GE(low->w, 0.01f * 0.999f);
  EXPECT_LE(low->w, 0.02f);
  EXPECT_LE(high->w, 10.01f);
  EXPECT_GE(high->w, 5.0f);
}

TEST(Scenes, BadOptionsAreNamed) {
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  expect_error([] { make_scene({.name = "no such scene"}); }, "no such scene");
  expect_error([] { make_scene({.name = "no such scene"}); }, "random");
  for (float radius : {-1.0f, nan, infinity}) expect_error([=] { make_scene({.radius = radius}); }, "radius");
  for (float ratio : {0.5f, -2.0f, nan, infinity}) expect_error([=] { make_scene({.radius_ratio = ratio}); }, "ratio");
  for (double fraction : {0.0, -0.1, double(nan), double(infinity)})
    expect_error([=] { make_scene({.name = "uniform", .packing_fraction = fraction}); }, "fraction");
  for (float offset : {nan, infinity}) expect_error([=] { make_scene({.offset = offset}); }, "offset");
}

TEST(Scenes, BadInputIsCountedAndTheFirstNamed) {
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  const auto spoiled = [](const std::function<void(Scene&)>& spoil) {
    return [spoil] {
      Scene scene = make_scene({.n = 100});
      spoil(scene);
      check_scene(scene);
    };
  };
  EXPECT_NO_THROW(spoiled([](Scene&) {})());
  const auto two = [=](Scene& scene) { scene.positions[77].y = nan, scene.positions[41].z = infinity; };
  expect_error(spoiled(two), "41");
  expect_error(spoiled(two), "2");
  expect_error(spoiled([](Scene& scene) { scene.positions[63].w = -0.25f; }), "63");
  expect_error(spoiled([=](Scene& scene) { scene.positions[64].w = infinity; }), "64");
  expect_error(spoiled([=](Scene& scene) { scene.velocities[65].x = nan; }), "65");
}

class ScenesRefused : public BackendTest {};

TEST_P(ScenesRefused, ByUpload) {
  Scene scene = make_scene({.n = 100});
  scene.positions[31].x = std::nanf("");
  EXPECT_THROW(backend().upload(scene), std::invalid_argument);
  scene.positions[31] = {0, 0, 0, -1};
  EXPECT_THROW(backend().upload(scene), std::invalid_argument);
}

TEST_P(ScenesRefused, OptionsThatDevicesLack) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU takes every method and group size";
  backend().upload(make_scene({.n = 100}));
  EXPECT_THROW(backend().collide({.block = 100}), std::invalid_argument);
  EXPECT_THROW(backend().collide({.method = Method::sequential}), std::invalid_argument);
}

TEST_P(ScenesRefused, ResultsBeforeACollisionStep) {
  backend().upload(make_scene({.n = 100}));
  EXPECT_THROW(backend().collisions(), BackendError);
  backend().collide(fast_method(backend()));
  EXPECT_NO_THROW(backend().collisions());
  EXPECT_THROW(backend().pairs(), BackendError) << "want_pairs was off";
  backend().move();
  EXPECT_THROW(backend().collisions(), BackendError) << "they belong to where the spheres were";
}

INSTANTIATE_BACKENDS(ScenesRefused);

TEST(Scenes, UnknownNamesAreErrors) {
  expect_error([] { method_from_name("collide_magic"); }, "collide_triangle");
  expect_error([] { open_backend("abacus"); }, "abacus");
  for (Method method : device_methods()) EXPECT_EQ(method_from_name(method_name(method)), method);
}

}  // namespace
}  // namespace spherepair
