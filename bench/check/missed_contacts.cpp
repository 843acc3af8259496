// SPDX-License-Identifier: MIT
#include "bench/check/missed_contacts.h"

#include <cmath>

#include "common/shared/hash.h"

namespace spherepair {
namespace {

double unit(uint64_t seed, uint64_t index) { return double(splitmix64(splitmix64(seed) + index) >> 40) * 0x1p-24; }

}  // namespace

Scene passing_scene(uint64_t pairs, double step_length, uint64_t seed) {
  constexpr float r = 0.5f;
  Scene scene{.name = "passing", .gravity = 0, .dt = 1};
  for (uint64_t k = 0; k < pairs; ++k) {
    const float y = 100 + 4 * float(k % 64), z = 4 * float(k / 64);
    const double distance = std::sqrt(unit(seed, 2 * k)), phase = unit(seed, 2 * k + 1);
    scene.positions.push_back({0, y, z, r});
    scene.positions.push_back({float(-1.5 - step_length * phase), y + float(distance), z, r});
    scene.velocities.push_back({0, 0, 0, 0});
    scene.velocities.push_back({float(step_length), 0, 0, 0});
  }
  return scene;
}

double expected_miss_share(double step_length) {
  return step_length <= 2 ? step_length * step_length / 12 : 1 - 4 / (3 * step_length);
}

uint64_t missed_pairs(Backend& backend, const Scene& scene, double step_length, bool swept) {
  std::vector<bool> found(scene.size());
  backend.upload(scene);
  for (int step = 0; step <= int(3 / step_length) + 2; ++step) {
    backend.collide({.method = Method::automatic, .swept = swept});
    const std::vector<uint> counts = backend.counts();
    for (size_t i = 0; i < found.size(); ++i) found[i] = found[i] || colliding(counts[i]);
    backend.move();
  }
  uint64_t missed = 0;
  for (size_t i = 1; i < found.size(); i += 2) missed += !found[i];
  return missed;
}

}  // namespace spherepair
