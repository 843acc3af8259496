// SPDX-License-Identifier: MIT
// The grid of the CPU on scenes drawn at random: all pairs give the same set.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>

#include "common/scene/contact_scenes.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

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
  const double densest = made_for_contacts(options.name) ? 0.5 : 0.7;
  options.packing_fraction = random() % 2 ? log_uniform(1e-12, densest) : 0.3;
  if (random() % 3 == 0) options.offset = float(log_uniform(1, 1e8)) * (random() % 2 ? 1.0f : -1.0f);
  return options;
}

// SOAK_SECONDS in the environment makes it longer; SOAK_SEED starts it elsewhere.
TEST(CpuGrid, Soak) {
  const char *seconds = std::getenv("SOAK_SECONDS"), *start = std::getenv("SOAK_SEED");
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds ? std::atof(seconds) : by_form(2, 1));
  uint64_t seed = start ? std::strtoull(start, nullptr, 10) : 1;
  const uint64_t first = seed;
  for (; std::chrono::steady_clock::now() < end; ++seed) {
    const SceneOptions options = drawn_scene(seed);
    ASSERT_EQ(first_grid_mismatch(make_scene(options)), "")
        << "SOAK_SEED=" << seed << ": " << options.name << " of " << options.n;
  }
  fmt::print("{} scenes from SOAK_SEED={} on\n", seed - first, first);
}

}  // namespace
}  // namespace spherepair
