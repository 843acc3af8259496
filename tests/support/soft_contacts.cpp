// SPDX-License-Identifier: MIT
#include "tests/support/soft_contacts.h"

#include <cmath>
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

}  // namespace

Scene gas(const GasOptions& o) {
  std::mt19937 random(28);
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

}  // namespace spherepair
