// SPDX-License-Identifier: MIT
// Every motion method in every precision: the same bits on every backend, whatever happens between the steps.
#include <fmt/format.h>

#include "common/scene/scene_params.h"
#include "common/shared/anchor.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

class MotionMethods : public KernelTest {};

// Powers of two and not, so that a backend that fuses products shows it; long steps hold many bounces each, and every
// bounce divides and takes a root.
TEST_P(MotionMethods, SameBitsAsOnTheCpu) {
  if (backend().info().on_host) GTEST_SKIP() << "it would be compared with itself";
  for (const MotionOptions& motion : all_motions())
    for (auto [dt, restitution, steps] : {std::tuple(0x1p-6f, 1.0f, 400), std::tuple(0.01f, 0.9f, 400),
                                          std::tuple(0.7f, 0.96f, 60), std::tuple(10.0f, 0.5f, 12)}) {
      const uint64_t n = by_form(backend(), 2000u, 300u);
      const Scene scene = awkward_scene({.motion = motion, .dt = dt, .restitution = restitution, .n = n});
      expect_equal_states(run_steps(backend(), scene, steps), run_steps(cpu_backend(), scene, steps),
                          fmt::format("{}, dt {}, restitution {}", motion_label(motion), dt, restitution));
      backend().check_guards();
    }
}

// Enough spheres for several threads of the CPU and for a device's many groups.
TEST_P(MotionMethods, SameBitsWithManySpheres) {
  for (const MotionOptions& motion : all_motions()) {
    const Scene scene = awkward_scene({.motion = motion, .dt = 0.1f, .restitution = 0.9f, .n = 20'001});
    expect_equal_states(run_steps(backend(), scene, 10), run_steps(cpu_backend(), scene, 10), motion_label(motion));
  }
}

// Without gravity nothing falls back, and a bounce is the last.
TEST_P(MotionMethods, SameBitsWithoutGravity) {
  for (const MotionOptions& motion : all_motions()) {
    Scene scene = awkward_scene({.motion = motion, .dt = 0.25f, .restitution = 0.75f, .n = 500});
    scene.gravity = 0;
    expect_equal_states(run_steps(backend(), scene, 50), run_steps(cpu_backend(), scene, 50), motion_label(motion));
  }
}

TEST_P(MotionMethods, UndisturbedByCollisionStepsAndByAsking) {
  for (const MotionOptions& motion : all_motions()) {
    const Scene scene = bouncing_scene({.motion = motion, .restitution = 0.9f, .n = 300});
    backend().upload(scene);
    for (int step = 0; step < 120; ++step) {
      backend().move();
      if (step % 7 == 0) run_step(backend(), {.method = fast_method(backend()).method});
      if (step % 11 == 0) current_state(backend());
    }
    expect_equal_states(current_state(backend()), run_steps(cpu_backend(), scene, 120), motion_label(motion));
  }
}

// The pairs are those of the present positions, also where a method evaluates these only on request.
TEST_P(MotionMethods, CollisionsAreThoseOfThePresentPositions) {
  for (const MotionOptions& motion : all_motions()) {
    const Scene scene = bouncing_scene({.motion = motion, .n = 1500});
    backend().upload(scene);
    for (int step = 0; step < 90; ++step) backend().move();
    const StepResult answer = run_step(backend(), {.method = fast_method(backend()).method, .want_pairs = true});
    Scene there = scene;
    there.positions = current_state(backend()).positions;
    EXPECT_EQ(backend().counts(), answer.counts) << "asking for the state must not touch the results";
    EXPECT_EQ(backend().pairs(), *answer.pairs);
    Backend& cpu = cpu_backend();
    cpu.upload(there);
    const StepResult wanted = run_step(cpu, {.method = Method::sequential, .want_pairs = true});
    EXPECT_EQ(first_mismatch(answer, *wanted.pairs, scene.size()), "") << motion_label(motion);
    EXPECT_GT(wanted.pairs->size(), 0u);
  }
}

// A sphere that is looked at before its due step has not bounced; one that is looked at then mostly has.
template <typename Real>
void expect_no_bounce_before_due(float dt, float restitution) {
  const Scene scene = bouncing_scene({.motion = {MotionMethod::anchored, {}}, .dt = dt, .restitution = restitution});
  MotionParams params = motion_params(scene);
  uint64_t bounces = 0, looks = 0;
  for (uint64_t i = 0; i < scene.size(); ++i) {
    Anchor<Real> anchor = {scene.positions[i], 0, 0, widened(scene.velocities[i].y, Real{}), widened(0.0f, Real{}), 0};
    uint due = next_event_step(anchor, params);
    for (params.steps_done = 1; params.steps_done <= 2000 && due != NO_EVENT; ++params.steps_done) {
      const Anchor<Real> next = anchor_anew(anchor, params);
      const bool bounced = next.since != anchor.since;
      ASSERT_FALSE(bounced && params.steps_done < due) << "sphere " << i << " bounces before step " << due;
      bounces += bounced, looks += params.steps_done >= due;
      anchor = next;
      if (bounced) due = next_event_step(anchor, params);
    }
  }
  EXPECT_LE(double(looks), 1.01 * double(bounces)) << "dt " << dt << ", restitution " << restitution;
}

TEST(MotionAnchors, DueStepsMissNoBounce) {
  for (auto [dt, restitution] : {std::pair(0x1p-6f, 1.0f), std::pair(0.01f, 0.9f), std::pair(0.1f, 0.5f)}) {
    expect_no_bounce_before_due<float>(dt, restitution);
    expect_no_bounce_before_due<Two>(dt, restitution);
    expect_no_bounce_before_due<double>(dt, restitution);
  }
}

TEST_P(MotionMethods, EveryNumberOfSpheres) {
  for (const MotionOptions& motion : all_motions())
    for (uint64_t n : {0, 1, 2, 127, 128, 129, 1023, 1025}) {
      const Scene scene = bouncing_scene({.motion = motion, .n = n});
      expect_equal_states(run_steps(backend(), scene, 40), run_steps(cpu_backend(), scene, 40),
                          fmt::format("{}, {} spheres", motion_label(motion), n));
      backend().check_guards();
    }
}

TEST_P(MotionMethods, RefusesWhatItCannotMove) {
  const auto refused = [&](auto change) {
    for (const MotionOptions& motion : all_motions()) {
      Scene scene = bouncing_scene({.motion = motion, .n = 3});
      change(scene);
      backend().upload(scene);
      EXPECT_THROW(backend().move(), std::invalid_argument) << motion_label(motion);
    }
  };
  refused([](Scene& scene) { scene.gravity = 1; });
  refused([](Scene& scene) { scene.dt = 0; });
  refused([](Scene& scene) { scene.restitution = 1.5f; });
  refused([](Scene& scene) { scene.velocities[1].x = 0x1p61f; });
}

// Spheres that bounce, that come to rest and that rise for ever; of all that is kept, not only of where they are.
TEST_P(MotionMethods, LookingAtSpheresThatAreNotDueChangesNothing) {
  for (const MotionOptions motion : all_motions()) {
    if (motion.method != MotionMethod::anchored) continue;
    for (const float gravity : {-9.81f, 0.0f}) {
      Scene scene = make_scene({.name = "random", .n = 700, .motion = motion, .restitution = 0.5f});
      scene.gravity = gravity;
      std::array<MotionState, 2> kept;
      std::array<Motion::State, 2> states;
      for (const bool event_driven : {false, true}) {
        backend().upload(scene);
        backend().set_event_driven(event_driven);
        for (int step = 0; step < 400; ++step) backend().move();
        states[event_driven] = current_state(backend());
        kept[event_driven] = backend().save();
      }
      EXPECT_EQ(state_hash(states[0].positions, states[0].velocities, states[0].wide),
                state_hash(states[1].positions, states[1].velocities, states[1].wide))
          << motion_label(motion) << ", gravity " << gravity;
      EXPECT_EQ(kept[0].since, kept[1].since) << motion_label(motion);
      EXPECT_EQ(kept[0].flights, kept[1].flights) << motion_label(motion);
      EXPECT_EQ(kept[0].next_event, kept[1].next_event) << motion_label(motion);
      EXPECT_GT(std::ranges::count_if(kept[1].since, [](uint since) { return since != 0; }), 100);
    }
  }
}

INSTANTIATE_BACKENDS(MotionMethods);

}  // namespace
}  // namespace spherepair
