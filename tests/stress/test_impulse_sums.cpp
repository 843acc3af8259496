// SPDX-License-Identifier: MIT
// Impulses summed in float32, which the integer sums are measured against: in a fixed order, with the same bits on
// every backend, and by atomics.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

constexpr uint64_t enough = 700;  // steps in which spheres of every scene run into each other

class SumsOfImpulses : public KernelTest {
 protected:
  void TearDown() override {
    if (IsSkipped()) return;
    for (Backend* used : {&backend(), &cpu_backend()}) used->sum_impulses(ImpulseSums::integers);
  }
  bool has_atomics() {
    try {
      backend().sum_impulses(ImpulseSums::atomics);
      return true;
    } catch (const std::invalid_argument& lacking) {
      EXPECT_NE(std::string(lacking.what()).find("no atomic addition of float32"), std::string::npos);
      return false;
    }
  }
};

Motion::State run_by(ImpulseSums sums, Backend& backend, const Scene& scene, uint64_t steps) {
  backend.sum_impulses(sums);
  return run_steps(backend, scene, steps);
}

// A large sphere that a hundred touch, a gas with a damper, and one of radii 1:8, whose large ones have long rows.
std::vector<Scene> crowded_scenes() {
  std::vector<Scene> scenes = {shells(ContactLaw::spring), shells(ContactLaw::hertz), gas({.gravity = -9.81f}),
                               gas({.ratio = 8, .gravity = -9.81f})};
  scenes.push_back(gas({.gravity = -9.81f, .restitution = 0.7f, .law = ContactLaw::spring}));
  return scenes;
}

// All pairs, each sphere's others by ascending index, without lists of near pairs.
std::vector<uint> after_sums_in_order(const Scene& scene, uint64_t steps) {
  const ContactParams c = contact_params(scene);
  const uint64_t n = scene.size();
  std::vector<uint> wide = fixed_state(scene);
  const auto body = [&](const std::vector<uint>& words, uint64_t i) { return load_body(words, scene.positions, i); };
  for (uint64_t step = 0; step < steps; ++step) {
    const std::vector<uint> before = wide;
    for (uint64_t i = 0; i < n; ++i) {
      float x = 0, y = 0, z = 0;
      for (uint64_t j = 0; j < n; ++j) {
        if (j == i) continue;
        const FloatPush push = float_push_of_pair(body(before, i), body(before, j), c);
        x += push.x, y += push.y, z += push.z;
      }
      const Body s = body(before, i);
      const Push sum = {integer_of(x), integer_of(y), integer_of(z), FAULTS};
      const Body faster = kicked(s, sum, push_of_walls(s, false, c), c);
      const float mobility = mobility_of(s.radius, c);
      store_body(wide, n, i, drifted(faster, speeds_of(faster, mobility), mobility, c));
    }
  }
  return wide;
}

TEST_P(SumsOfImpulses, InOrderAreThoseOfAllPairsByAscendingIndex) {
  for (const Scene& scene : {shells(ContactLaw::spring), gas({.side = 5, .ratio = 8, .gravity = -9.81f})}) {
    const std::vector<uint> wanted = after_sums_in_order(scene, enough);
    EXPECT_TRUE(run_by(ImpulseSums::in_order, backend(), scene, enough).wide == wanted) << scene.name;
    backend().check_guards();
  }
}

// Many steps, through several lists of near pairs.
TEST_P(SumsOfImpulses, InOrderHaveTheBitsOfTheCpu) {
  for (const Scene& scene : crowded_scenes()) {
    const Motion::State wanted = run_by(ImpulseSums::in_order, cpu_backend(), scene, enough);
    expect_equal_states(run_by(ImpulseSums::in_order, backend(), scene, enough), wanted, scene.name);
    if (scene.name != "shells") continue;  // a sphere of the gases seldom has several contacts at once
    EXPECT_TRUE(wanted.wide != run_by(ImpulseSums::integers, cpu_backend(), scene, enough).wide);
  }
}

TEST_P(SumsOfImpulses, CanChangeBetweenSteps) {
  const Scene scene = shells(ContactLaw::quartic);
  const auto alternating = [&](Backend& backend) {
    backend.upload(scene);
    for (uint64_t step = 0; step < 400; ++step) {
      backend.sum_impulses(step / 50 % 2 == 0 ? ImpulseSums::in_order : ImpulseSums::integers);
      backend.move();
    }
    return current_state(backend);
  };
  const Motion::State wanted = alternating(cpu_backend());
  EXPECT_TRUE(wanted.wide != run_by(ImpulseSums::integers, cpu_backend(), scene, 400).wide);
  expect_equal_states(alternating(backend()), wanted, "alternating");
}

float fastest_difference(const std::vector<vec4>& a, const std::vector<vec4>& b) {
  float largest = 0;
  for (uint64_t i = 0; i < a.size(); ++i)
    largest = std::max({largest, std::abs(a[i].x - b[i].x), std::abs(a[i].y - b[i].y), std::abs(a[i].z - b[i].z)});
  return largest;
}

// float32 rounds each impulse and each addition, by 2^-24 at most.
TEST_P(SumsOfImpulses, ByAtomicsAreWithinRoundingOfThoseInOrder) {
  if (!has_atomics()) GTEST_SKIP() << backend().info().name << " has none";
  for (const Scene& scene : crowded_scenes()) {
    const auto velocities = [&](ImpulseSums sums) { return run_by(sums, backend(), scene, enough).velocities; };
    const std::vector<vec4> by_atomics = velocities(ImpulseSums::atomics), in_order = velocities(ImpulseSums::in_order);
    EXPECT_LT(fastest_difference(by_atomics, in_order), 1e-4f) << scene.name;
    EXPECT_GT(fastest_difference(by_atomics, scene.velocities), 0.5f) << scene.name;
  }
}

INSTANTIATE_BACKENDS(SumsOfImpulses);

}  // namespace
}  // namespace spherepair
