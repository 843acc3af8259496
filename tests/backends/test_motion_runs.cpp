// SPDX-License-Identifier: MIT
// Rows 28 to 30 of the stress catalogue for every motion method: denormal velocities, equal bits in long runs, and
// runs that are interrupted and go on, here or on another backend.
#include <fmt/format.h>

#include <cmath>

#include "tests/oracle/adversarial.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

TEST_P(StressCatalogue, Row28_EveryMethodDecaysThroughDenormals) {
  if (backend().info().on_host) GTEST_SKIP() << "it would be compared with itself";
  Random random(28);
  for (const MotionOptions& motion : all_motions()) {
    Scene scene = awkward_scene({.motion = motion, .restitution = 0.5f, .n = 600});
    scene.gravity = -0x1p-60f;
    for (vec4& v : scene.velocities)
      v = {std::ldexp(float(random.uniform(-1, 1)), random.between(-149, -50)),
           std::ldexp(float(random.uniform(-1, 1)), random.between(-149, -50)), 0, 0};
    expect_equal_states(run_steps(backend(), scene, 150), run_steps(cpu_backend(), scene, 150), motion_label(motion));
  }
}

TEST_P(StressCatalogue, Row29_EveryMethodEqualsTheCpu) {
  if (backend().info().on_host) GTEST_SKIP() << "it would be compared with itself";
  const int rounds = full_stress() ? 100 : is_gpu(backend()) ? 20 : 1;
  for (const MotionOptions& motion : all_motions()) {
    const Scene scene = bouncing_scene({.motion = motion, .restitution = 0.96875f, .n = 512});
    backend().upload(scene);
    cpu_backend().upload(scene);
    for (int round = 1; round <= rounds; ++round) {
      for (int step = 0; step < 500; ++step) backend().move(), cpu_backend().move();
      expect_equal_states(current_state(backend()), current_state(cpu_backend()),
                          fmt::format("{} after {} steps", motion_label(motion), 500 * round));
    }
  }
}

Scene with_state(Scene scene, const Motion::State& state) {
  scene.positions = state.positions;
  scene.velocities = state.velocities;
  return scene;
}

// Saved on this backend at step 500 of 1000; gone on with here and on the CPU, after other work in between.
TEST_P(StressCatalogue, Row30_SavedAndResumed) {
  for (const MotionOptions& motion : all_motions()) {
    const Scene scene = bouncing_scene({.motion = motion, .restitution = 0.9f, .n = 200});
    const Motion::State wanted = run_steps(cpu_backend(), scene, 1000);
    const Motion::State middle = run_steps(backend(), scene, 500);
    const MotionState saved = backend().save();
    run_steps(backend(), bouncing_scene({.motion = {MotionMethod::anchored, Precision::compensated}, .n = 77}), 5);
    for (Backend* other : {&backend(), &cpu_backend()}) {
      other->resume(with_state(scene, middle), saved);
      EXPECT_GT(run_step(*other, fast_method(*other)).totals.pairs, 0u);
      expect_equal_states(current_state(*other), middle, motion_label(motion) + ", resumed");
      for (int step = 500; step < 1000; ++step) other->move();
      expect_equal_states(current_state(*other), wanted, motion_label(motion) + ", after 1000 steps");
    }
  }
}

}  // namespace
}  // namespace spherepair
