// SPDX-License-Identifier: MIT
// Drag, beds that come to rest to the bit, and spheres at rest that steps pass over: no bit is another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

class ContactRest : public KernelTest {};

Scene awake(Scene scene) {
  scene.contact.sleeping = false;
  return scene;
}

Scene soft_bed(uint64_t n, double drag_a_step) {
  Scene scene = make_scene({.name = "bed", .n = n});
  scene.restitution = 1;
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1e6f});
  scene.restitution = 0.3f;  // 40 steps a contact without the damper
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1e6f, .dt = scene.dt, .drag = 1});
  scene.contact.drag = float(drag_a_step / double(scene.dt));
  return scene;
}

// At first some spheres rest and others fall; in the end nothing moves by a unit.
TEST_P(ContactRest, BedsRestToTheBitWithSpheresPassedOverOrNot) {
  const uint64_t n = by_form(backend(), 40u, 27u);
  const Scene scene = soft_bed(n, 0.02);
  backend().upload(scene);
  Backend& cpu = cpu_backend();
  cpu.upload(awake(scene));
  uint64_t step = 0;
  bool at_rest = false;
  for (std::vector<uint> before; step < 60'000 && !at_rest; before = cpu.state().wide) {
    for (int k = 0; k < 500; ++k, ++step) backend().move(), cpu.move();
    expect_equal_states(current_state(backend()), current_state(cpu), fmt::format("{} spheres, step {}", n, step));
    at_rest = before == cpu.state().wide;
  }
  EXPECT_TRUE(at_rest);
  EXPECT_GT(step, 1000u);
}

// One that falls onto those that have long been at rest, which are in contact with others at rest; before them and
// behind them in the order of spheres.
TEST_P(ContactRest, WhatIsHitAwakens) {
  for (const uint64_t falling : {3u, 0u}) {
    std::vector<vec4> spheres = {{0, 0.5f, 0, 0.5f}, {0, 1.49f, 0, 0.5f}, {0, 2.48f, 0, 0.5f}, {0.1f, 9, 0.05f, 0.5f}};
    if (falling == 0) std::ranges::reverse(spheres);
    Scene scene = scene_of(spheres);
    scene.plane = 0, scene.restitution = 0.5f;
    choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1e6f, .drag = 1});
    scene.contact.drag = float(0.02 / double(scene.dt));
    std::vector<uint> rested;
    backend().upload(scene), cpu_backend().upload(awake(scene));
    uint64_t done = 0;
    for (const uint64_t steps : {3000u, 3001u, 8000u, 16'000u}) {
      for (; done < steps; ++done) backend().move(), cpu_backend().move();
      const Motion::State state = current_state(backend());
      expect_equal_states(state, current_state(cpu_backend()), fmt::format("{} steps", steps));
      if (steps == 3000) rested = state.wide;
      const auto moved = [&](uint64_t k) { return word(rested, k) != word(state.wide, k); };
      if (steps == 3001) {
        for (uint64_t k = 0; k < 24; ++k) EXPECT_TRUE(k % 4 == falling || !moved(k)) << "at rest: " << k;
        EXPECT_TRUE(moved(4 + falling)) << "falls along y";
      }
      EXPECT_TRUE(steps != 16'000 || (moved(1) && moved(2))) << "pushed aside";
    }
  }
}

struct Saved {
  Scene scene;
  MotionState state;
};

// These spheres at rest, and more that fly.
Saved joined_by(const Scene& at_rest, const Motion::State& state, const Scene& flying) {
  Scene scene = with(at_rest, state);
  scene.positions.insert(scene.positions.end(), flying.positions.begin(), flying.positions.end());
  scene.velocities.insert(scene.velocities.end(), flying.velocities.begin(), flying.velocities.end());
  const uint64_t before = at_rest.size(), n = scene.size();
  MotionState saved;
  saved.wide = fixed_state(scene);
  for (uint64_t i = 0; i < before; ++i) store_body(saved.wide, n, i, load_body(state.wide, state.positions, i));
  return {std::move(scene), std::move(saved)};
}

// The upper of two at rest is thrown off farther than the skins in one step, so that the next list lacks their pair:
// the lower carries nothing from then on.
TEST_P(ContactRest, WhatLosesANearPairAwakens) {
  Scene stack = scene_of({{0, 0.5f, 0, 0.5f}, {0, 1.49f, 0, 0.5f}});
  stack.plane = 0;
  Motion::State rest;
  for (float dt = 0.016f; rest.wide.empty() || rest.wide != run_steps(cpu_backend(), stack, 4001).wide; dt *= 0.99f) {
    ASSERT_GT(dt, 0.014f) << "so coarse that few steps of this drag come to rest";
    choose_contacts(stack, {.law = ContactLaw::spring, .stiffness = 1e6f, .dt = dt, .drag = 0.39f / dt});
    rest = run_steps(cpu_backend(), stack, 4000);
  }
  const float up = std::sin(0.3f), along = std::cos(0.3f), speed = 15, from = 1.04f;
  Scene flying;
  for (const auto& [x, z] : {std::pair(1.0f, 0.0f), {-1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, -1.0f}}) {
    flying.positions.push_back({from * along * x, rest.positions[1].y - from * up, from * along * z, 0.5f});
    flying.velocities.push_back({-speed * along * x, speed * up, -speed * along * z, 0});
  }
  Saved joined = joined_by(stack, rest, flying);
  std::vector<uint> thrown;
  for (uint64_t steps = 1; steps < 12; ++steps) {
    std::vector<Motion::State> states;
    for (const bool sleeping : {true, false}) {
      joined.scene.contact.sleeping = sleeping;
      Backend& one = sleeping ? backend() : cpu_backend();
      one.resume(joined.scene, joined.state);
      for (uint64_t step = 0; step < steps; ++step) one.move();
      states.push_back(current_state(one));
    }
    expect_equal_states(states[0], states[1], fmt::format("{} steps", steps));
    thrown = states[0].wide;
  }
  EXPECT_NE(word(thrown, 6), word(joined.state.wide, 6)) << "the lower has risen";
}

// Which the thread of sphere 0 looks for.
TEST_P(ContactRest, FaultsAreSeenWhereSphere0Rests) {
  Scene scene = scene_of({{0.1f, 1, 0, 0.001f}, {0, 1, 0, 0.001f}, {0.0051f, 1, 0, 0.004f}, {-0.0051f, 1, 0, 0.004f}});
  scene.velocities = {{0, 0, 0, 0}, {0, 0, 0, 0}, {-0.17f, 0, 0, 0}, {0.17f, 0, 0, 0}};
  scene.plane = 0, scene.gravity = 0;
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1, .dt = 5e-6f, .drag = 0.01f});
  std::string texts[2];
  for (const bool sleeping : {true, false}) {
    Backend& one = sleeping ? backend() : cpu_backend();
    one.upload(sleeping ? scene : awake(scene));
    try {
      for (int step = 0; step < 4000; ++step) one.move();
      one.evaluate_state();
    } catch (const std::invalid_argument& fault) {
      texts[sleeping] = std::string(fault.what()).substr(one.info().name.size());
    }
  }
  EXPECT_NE(texts[true].find("sphere 1 is deeper in sphere 2"), std::string::npos) << texts[true];
  EXPECT_EQ(texts[true], texts[false]);
}

TEST_P(ContactRest, SavedAndResumedAtRest) {
  const Scene scene = soft_bed(27, 0.02);
  const Motion::State wanted = run_steps(cpu_backend(), awake(scene), 9000), middle = run_steps(backend(), scene, 6000);
  const MotionState saved = backend().save();
  backend().resume(with(scene, middle), saved);
  for (int step = 6000; step < 9000; ++step) backend().move();
  expect_equal_states(current_state(backend()), wanted, "resumed");
}

TEST(ContactRestOptions, DragHasABoundByTheTimeStep) {
  Scene scene = scene_of({{0, 1, 0, 0.5f}});
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1, .dt = 1e-3f, .drag = 399});
  EXPECT_EQ(why_no_contacts(scene), "");
  for (const float drag : {401.0f, -1.0f, NAN, INFINITY}) {
    scene.contact.drag = drag;
    EXPECT_NE(why_no_contacts(scene).find("the drag is"), std::string::npos) << drag;
  }
}

INSTANTIATE_BACKENDS(ContactRest);

}  // namespace
}  // namespace spherepair
