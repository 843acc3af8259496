// SPDX-License-Identifier: MIT
// Rows 28 and 33 of the stress catalogue: motion through denormals, and every awkward number of spheres.
#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "tests/oracle/adversarial.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/reference_motion.h"
#include "tests/support/backends.h"
#include "tests/support/catalogue.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

// Spheres below the plane without gravity: every step turns the velocity round and halves it, down to nothing.
Scene decaying_scene(uint64_t n, double slowest, double fastest) {
  Random random(28);
  Scene scene = scene_of(std::vector<vec4>(n));
  for (uint64_t i = 0; i < n; ++i) {
    const auto speed = [&] { return std::ldexp(float(random.uniform(-1, 1)), int(random.uniform(slowest, fastest))); };
    scene.positions[i] = {speed(), -6, speed(), 0.5f};
    scene.velocities[i] = {speed(), speed(), speed(), 0};
  }
  scene.equal_radii = true;
  scene.gravity = 0;
  scene.restitution = 0.5f;
  return scene;
}

double seconds_for_steps(Backend& backend, const Scene& scene) {
  backend.upload(scene);
  backend.move();
  backend.finish();
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < 40; ++step) backend.move();
  backend.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The best rounds of both, taken in turn; more of them while other work on the machine may be what slows one down.
void expect_no_slowdown(Backend& backend, const Scene& normal, const Scene& decaying) {
  double quick = INFINITY, slow = INFINITY;
  for (int round = 0; round < 5 || (round < 40 && slow > 2 * quick); ++round) {
    quick = std::min(quick, seconds_for_steps(backend, normal));
    slow = std::min(slow, seconds_for_steps(backend, decaying));
  }
  fmt::print("{}: 40 steps of {} spheres take {:.3} ms, from denormal velocities {:.3} ms\n", backend.info().name,
             normal.size(), quick * 1e3, slow * 1e3);
  note_figure(fmt::format("{:.2f} times as slow", slow / quick));
  if (full_stress()) {  // a short run shares the machine with others
    EXPECT_LE(slow, 2 * quick);
  }
}

TEST_P(StressCatalogue, Row28_VelocitiesDecayThroughDenormals) {
  for (auto [slowest, fastest] : {std::pair(-70.0, -50.0), std::pair(-149.0, -110.0), std::pair(-20.0, 0.0)}) {
    const Scene scene = decaying_scene(1000, slowest, fastest);
    Motion::State wanted = {scene.positions, scene.velocities, {}};
    backend().upload(scene);
    for (int step = 0; step < 200; ++step) {
      backend().move();
      step_all(scene, wanted);
    }
    expect_equal_states(current_state(backend()), wanted, "after 200 steps");
  }
  expect_no_slowdown(backend(), decaying_scene(65536, 0, 3), decaying_scene(65536, -149, -110));
}

void check_motion(Backend& backend, const Scene& scene, int steps) {
  Motion::State wanted = {scene.positions, scene.velocities, {}};
  backend.upload(scene);
  for (int step = 0; step < steps; ++step) {
    backend.move();
    step_all(scene, wanted);
  }
  backend.check_guards();
  expect_equal_states(current_state(backend), wanted, fmt::format("{} spheres", scene.size()));
}

TEST_P(StressCatalogue, Row33_NoneOneTwoSpheres) {
  for (uint64_t n : {0, 1, 2, 3}) {
    const Scene scene = make_scene({.name = "coincident", .n = n});
    expect_pairs(backend(), scene, brute_force_pairs(scene.positions), every_method(backend(), block_sizes()));
    check_motion(backend(), make_scene({.name = "random", .n = n}), 80);
  }
  EXPECT_TRUE(backend().decide({}).empty());
}

TEST_P(StressCatalogue, Row33_GroupSizePlusMinusOne) {
  for (uint block : block_sizes())
    for (uint64_t n : {block - 1, block, block + 1}) {
      const Scene scene = make_scene({.name = "uniform", .n = n});
      const std::vector<uint> one_size = {block};
      expect_pairs(backend(), scene, brute_force_pairs(scene.positions), every_method(backend(), one_size));
      check_motion(backend(), make_scene({.name = "random", .n = n}), 3);
    }
}

// More groups of 64 than one dimension of a grid may have in OpenGL and in old CUDA.
TEST_P(StressCatalogue, Row33_MoreThan65535Groups) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU has no groups";
  const Scene scene = make_scene({.name = "uniform", .n = 65535 * 64 + 1, .packing_fraction = 0.05});
  check_motion(backend(), scene, 1);
  const std::vector<Pair> expected = swept_pairs(scene.positions);
  backend().upload(scene);
  for (const CollideOptions& options : every_method(backend(), block_sizes().subspan(1, 1))) {
    const bool group = options.method == Method::collide_group;
    if (!group && !is_gpu(backend())) continue;
    const std::vector<Pair> wanted = group ? within_groups(expected, options.block) : expected;
    EXPECT_EQ(first_mismatch(run_step(backend(), options), wanted, scene.size()), "") << describe(options);
  }
}

}  // namespace
}  // namespace spherepair
