// SPDX-License-Identifier: MIT
#include "tests/support/motion_runs.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "api/open.h"
#include "tests/oracle/adversarial.h"
#include "tests/support/catalogue.h"

namespace spherepair {

Scene bouncing_scene(const BouncingOptions& o) {
  return make_scene({.name = "random", .n = o.n, .motion = o.motion, .dt = o.dt, .restitution = o.restitution});
}

Scene awkward_scene(const BouncingOptions& o) {
  Random random(22);
  Scene scene = bouncing_scene(o);
  const auto any = [&](int low, int high) {
    return std::ldexp(float(random.uniform(-1, 1)), random.between(low, high));
  };
  for (uint64_t i = 0; i < scene.size(); ++i) {
    vec4 &at = scene.positions[i], &v = scene.velocities[i];
    at = {any(-20, 10), at.y, any(-70, 10), std::abs(any(-10, 1))};
    v = {any(-20, 6), any(-20, 6), any(-80, 6), 0};
    if (i % 8 == 0) at.y = scene.plane + at.w, v.y = 0;
    if (i % 8 == 1) at.y = scene.plane - at.w;
    if (i % 8 == 2) at.y = scene.plane + at.w, v.y = any(-40, -5);
  }
  scene.equal_radii = false;
  return scene;
}

Motion::State run_steps(Motion& motion, const Scene& scene, uint64_t steps) {
  motion.upload(scene);
  for (uint64_t step = 0; step < steps; ++step) motion.move();
  return current_state(motion);
}

Backend& cpu_backend() {
  static const std::unique_ptr<Backend> cpu = open_backend("cpu", {.threads = 1});
  return *cpu;
}

void expect_equal_states(const Motion::State& given, const Motion::State& wanted, const std::string& where) {
  count_figure("states");
  ASSERT_EQ(given.positions.size(), wanted.positions.size()) << where;
  ASSERT_EQ(given.velocities.size(), wanted.velocities.size()) << where;
  for (size_t i = 0; i < wanted.positions.size(); ++i) {
    const vec4 &p = given.positions[i], &q = wanted.positions[i], &v = given.velocities[i], &w = wanted.velocities[i];
    ASSERT_EQ(std::memcmp(&p, &q, sizeof p), 0)
        << fmt::format("{}, sphere {}: ({:a}, {:a}, {:a}; {:a}) is not ({:a}, {:a}, {:a}; {:a})", where, i, p.x, p.y,
                       p.z, p.w, q.x, q.y, q.z, q.w);
    ASSERT_EQ(std::memcmp(&v, &w, sizeof v), 0)
        << fmt::format("{}, velocity of sphere {}: ({:a}, {:a}, {:a}) is not ({:a}, {:a}, {:a})", where, i, v.x, v.y,
                       v.z, w.x, w.y, w.z);
  }
  ASSERT_EQ(given.wide.size(), wanted.wide.size()) << where;
  for (size_t k = 0; k < wanted.wide.size(); ++k)
    ASSERT_EQ(given.wide[k], wanted.wide[k]) << where << ", word " << k << " of the wide state";
}

}  // namespace spherepair
