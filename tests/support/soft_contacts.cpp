// SPDX-License-Identifier: MIT
#include "tests/support/soft_contacts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

// A sixty-fourth of the default stiffness: contacts last eight times as long, and short runs have many.
void choose_soft_contacts(Scene& scene, ContactLaw law, bool walls, double steps = 40) {
  choose_contacts(scene, {.law = law});
  choose_contacts(scene, {.law = law, .stiffness = scene.contact.stiffness / 64});
  const float dt = float(contact_time(scene) / steps);
  choose_contacts(scene, {.law = law, .stiffness = scene.contact.stiffness, .dt = dt, .walls = walls});
}

// The momenta of a step later belong to the way back: they are those of half a step after these positions.
MotionState turned(const std::vector<uint>& now, const std::vector<uint>& later, uint64_t n) {
  MotionState state;
  state.wide = now;
  for (uint64_t k = 3 * n; k < 6 * n; ++k) store_real(state.wide, k, -word(later, k));
  return state;
}

// The first contact of these positions is lost: what its spheres give each other in the next step is taken back.
void drop_a_contact(const Scene& scene, std::vector<uint>& wide) {
  const uint64_t n = scene.size();
  const auto body = [&](uint64_t i) { return load_body(wide, scene.positions, i); };
  for (uint64_t i = 0; i < n; ++i)
    for (uint64_t j = 0; j < i; ++j) {
      const Push push = push_of_pair(body(i), body(j), contact_params(scene));
      const int64_t impulse[3] = {push.x, push.y, push.z};
      if (impulse[0] == 0 && impulse[1] == 0 && impulse[2] == 0) continue;
      for (uint64_t axis = 0; axis < 3; ++axis) {
        store_real(wide, (3 + axis) * n + i, word(wide, (3 + axis) * n + i) - impulse[axis]);
        store_real(wide, (3 + axis) * n + j, word(wide, (3 + axis) * n + j) + impulse[axis]);
      }
      return;
    }
  ADD_FAILURE() << "no spheres touch";
}

}  // namespace

Scene gas(const GasOptions& o) {
  std::mt19937 random(o.seed);
  std::uniform_real_distribution<float> any(-1, 1);
  Scene scene{.name = "gas", .plane = o.from, .gravity = o.gravity, .restitution = o.restitution};
  const float gap = 1.05f * o.ratio;
  for (uint64_t k = 0; k < o.side * o.side * o.side; ++k) {
    const float radius = 0.5f * std::exp2(std::log2(o.ratio) * (any(random) + 1) / 2);
    const auto along = [&](uint64_t cell) { return o.from + (float(cell) + 0.5f) * gap; };
    scene.positions.push_back({along(k % o.side), along(k / o.side % o.side), along(k / o.side / o.side), radius});
    scene.velocities.push_back({any(random), any(random), any(random), 0});
  }
  scene.equal_radii = o.ratio == 1;
  choose_soft_contacts(scene, o.law, true, o.steps_a_contact);
  return scene;
}

Scene shells(ContactLaw law) {
  Scene scene{.name = "shells", .positions = {{0, 0, 0, 4}}, .velocities = {{}}, .plane = -100, .gravity = 0};
  std::mt19937 random(8);
  std::uniform_real_distribution<float> any(-0.2f, 0.2f);
  for (uint64_t k = 0; k < 200; ++k) {
    const float distance = k < 100 ? 4.55f : 5.8f, speed = k < 100 ? 1 : 3;
    const double height = 1 - 2 * (double(k % 100) + 0.5) / 100, angle = 2.39996 * double(k % 100);
    const double around = std::sqrt(1 - height * height);
    const float x = float(around * std::cos(angle)), y = float(height), z = float(around * std::sin(angle));
    scene.positions.push_back({x * distance, y * distance, z * distance, 0.5f});
    scene.velocities.push_back({any(random) - speed * x, any(random) - speed * y, any(random) - speed * z, 0});
  }
  scene.equal_radii = false;
  choose_soft_contacts(scene, law, false);
  return scene;
}

std::vector<uint> shuffled(uint64_t n) {
  std::vector<uint> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::shuffle(order, std::mt19937(5));
  return order;
}

Scene in_order(const Scene& scene, std::span<const uint> order) {
  Scene other = scene;
  for (uint64_t k = 0; k < order.size(); ++k)
    other.positions[k] = scene.positions[order[k]], other.velocities[k] = scene.velocities[order[k]];
  return other;
}

std::vector<uint> in_order(const std::vector<uint>& wide, std::span<const uint> order) {
  const uint64_t n = order.size();
  std::vector<uint> other(wide.size());
  for (uint64_t part = 0; part < 6; ++part)
    for (uint64_t k = 0; k < n; ++k) store_real(other, part * n + k, word(wide, part * n + order[k]));
  return other;
}

Scene with(Scene scene, const Motion::State& state) {
  scene.positions = state.positions;
  scene.velocities = state.velocities;
  return scene;
}

std::vector<uint> there_and_back(Backend& backend, const Scene& scene, uint64_t steps, bool drops_a_contact) {
  const uint64_t n = scene.size();
  const Motion::State far = run_steps(backend, scene, steps);
  backend.move();
  MotionState back = turned(far.wide, current_state(backend).wide, n);
  if (drops_a_contact) drop_a_contact(scene, back.wide);
  backend.resume(with(scene, far), back);
  for (uint64_t step = 0; step < steps; ++step) backend.move();
  return current_state(backend).wide;
}

void expect_near_pairs_listed_seldom(Backend& backend, const Scene& scene) {
  constexpr uint64_t steps = 500;
  std::vector<uint> states[2];
  uint64_t searches[2];
  for (const bool keep : {false, true}) {
    backend.keep_near_pairs(keep);
    backend.upload(scene);
    const uint64_t before = backend.work_counts().steps;
    for (uint64_t step = 0; step < steps; ++step) backend.move();
    searches[keep] = backend.work_counts().steps - before;
    states[keep] = current_state(backend).wide;
  }
  EXPECT_EQ(states[true], states[false]);
  EXPECT_GE(searches[false], steps);
  EXPECT_LT(searches[true], steps / 4);
  EXPECT_GT(searches[true], 2u);
}

}  // namespace spherepair
