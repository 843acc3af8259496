// SPDX-License-Identifier: MIT
// Rows 21 to 27 of the stress catalogue: what each motion method is worth. Where OpenGL is software, shorter runs.
#include <fmt/format.h>

#include <cmath>

#include "common/shared/motion.h"
#include "tests/support/catalogue.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

bool slow_steps(const Backend& backend) { return backend.info().software && !full_stress(); }

constexpr MotionMethod EVENTS[] = {MotionMethod::impact, MotionMethod::anchored};

double height_of(const Scene& scene, const ExactState& state, uint64_t i) {
  return double(state[1] - ((long double)(scene.plane) + scene.positions[i].w));
}

// 490 m: float32 has steps of 3e-5 m there, so that anchored is held to two of them.
TEST_P(StressCatalogue, Row21_FreeFall) {
  const auto largest = [&](MotionOptions motion, int k) {
    Scene scene = bouncing_scene({.motion = motion, .dt = std::ldexp(1.0f, -k)});
    scene.plane = -2000;
    const double error = errors_of(scene, 10u << k, run_steps(backend(), scene, 10u << k)).largest;
    if (k == 6) note_figure(fmt::format("{} {:.1e} m", motion_label(motion), error), "f64 1e-12, f32 2 ulp = 6.1e-5");
    return error;
  };
  for (int k : {4, 6, 8}) {
    for (MotionMethod method : {MotionMethod::paper, MotionMethod::impact, MotionMethod::anchored})
      EXPECT_LE(largest({method, Precision::float64}, k), 1e-12) << motion_name(method) << " at dt = 2^-" << k;
    EXPECT_LE(largest({MotionMethod::impact, Precision::compensated}, k), 1e-10);
    EXPECT_LE(largest({MotionMethod::anchored, Precision::float32}, k), 0x1p-14) << "at dt = 2^-" << k;
  }
}

// At most 1e-9 of the energy in 10^6 steps of 1/64 s, compensated, and a tenth of that in float64.
TEST_P(StressCatalogue, Row23_EnergyOfAMillionSteps) {
  const uint64_t steps = slow_steps(backend()) ? 3000 : 1'000'000;
  for (MotionMethod method : EVENTS)
    for (auto [precision, bound] : {std::pair(Precision::float64, 1e-10), std::pair(Precision::compensated, 1e-9)}) {
      const Scene scene = bouncing_scene({.motion = {method, precision}, .n = 16});
      const double gained = errors_of(scene, steps, run_steps(backend(), scene, steps)).energy;
      fmt::print("{}: {} gains {:.1e} of its energy in {} steps\n", backend().info().name, motion_label(scene.motion),
                 gained, steps);
      note_figure(fmt::format("{} {:.1e} in {} steps", motion_label(scene.motion), gained, steps),
                  "f64 1e-10, compensated 1e-9");
      EXPECT_LE(std::abs(gained), bound) << motion_label(scene.motion);
    }
}

TEST_P(StressCatalogue, Row24_ComesToRest) {
  const bool slow = slow_steps(backend());
  const float dt = slow ? 2 : 0x1p-6f;
  for (MotionMethod method : EVENTS)
    for (Precision precision : PRECISIONS) {
      double lowest = 0, highest = 0;
      for (float restitution : {0.0f, 0.5f, 0.9f}) {
        const Scene scene = bouncing_scene({{method, precision}, dt, restitution, 50});
        const Motion::State state = run_steps(backend(), scene, uint64_t(1000 / dt));
        for (uint64_t i = 0; i < scene.size(); ++i) {
          const ExactState sphere = exact_state(state, scene.motion, i);
          ASSERT_EQ(double(sphere[4]), 0) << motion_label(scene.motion) << ", e = " << restitution;
          const double height = height_of(scene, sphere, i);
          lowest = std::min(lowest, height), highest = std::max(highest, height);
          ASSERT_LE(std::abs(height), 0x1p-21) << motion_label(scene.motion);  // 1 ulp at 4.5 m
          ASSERT_FALSE(below_plane(state.positions[i].y, scene.positions[i].w, scene.plane));
        }
      }
      note_figure(fmt::format("{} at {:.0e} to {:.0e} m", motion_label({method, precision}), lowest, highest),
                  "v = 0, on the plane within 1 ulp");
    }
}

// Steps in which a sphere may bounce a hundred times: above the plane and no energy from nothing, at every step.
TEST_P(StressCatalogue, Row25_LongSteps) {
  note_figure("above the plane at every step", "energy not growing");
  for (MotionMethod method : EVENTS)
    for (Precision precision : PRECISIONS)
      for (auto [dt, restitution] : {std::pair(0.1f, 1.0f), std::pair(1.0f, 0.9f), std::pair(10.0f, 1.0f)}) {
        const Scene scene = bouncing_scene({{method, precision}, dt, restitution, 64});
        backend().upload(scene);
        for (int step = 1; step <= 40; ++step) {
          backend().move();
          const Motion::State state = current_state(backend());
          const double bound = precision == Precision::float32 ? 1e-4 : 1e-9;
          for (uint64_t i = 0; i < scene.size(); ++i) {
            const ExactState sphere = exact_state(state, scene.motion, i);
            const double height = height_of(scene, sphere, i);
            ASSERT_TRUE(height >= 0 && height < 30) << motion_label(scene.motion) << ", dt = " << dt;
            ASSERT_LE(error_of(scene, i, uint64_t(step), sphere).energy, bound) << motion_label(scene.motion);
          }
        }
      }
}

// 10 m a step, twenty diameters, down onto the plane.
TEST_P(StressCatalogue, Row26_FastSpheresStayAboveThePlane) {
  note_figure("0 of 200 at 1000 m/s", "0 crossings");
  for (MotionMethod method : EVENTS)
    for (Precision precision : PRECISIONS) {
      Scene scene = bouncing_scene({{method, precision}, 0.01f, 1, 200});
      for (uint64_t i = 0; i < scene.size(); ++i) scene.velocities[i].y = i % 2 == 0 ? -1000 : 1000;
      backend().upload(scene);
      for (int step = 0; step < 60; ++step) {
        backend().move();
        const Motion::State state = current_state(backend());
        for (uint64_t i = 0; i < scene.size(); ++i)
          ASSERT_GE(height_of(scene, exact_state(state, scene.motion, i), i), 0) << motion_label(scene.motion);
      }
    }
}

Scene distant_scene(MotionOptions motion, float distance) {
  Scene scene = scene_of({{distance, 5, -distance, 0.5f}, {distance / 2, 7, distance, 0.5f}});
  for (vec4& v : scene.velocities) v = {1, 0, -1, 0};
  scene.dt = 0.001f;
  scene.motion = motion;
  return scene;
}

// Along x and z only: the closed form is a product.
double displacement_error(Backend& backend, const Scene& scene, uint64_t steps) {
  const Motion::State state = run_steps(backend, scene, steps);
  double largest = 0;
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const ExactState sphere = exact_state(state, scene.motion, i);
    const long double moved = (long double)(scene.dt) * steps;
    largest = std::max(largest, double(std::abs(sphere[0] - (scene.positions[i].x + moved))));
    largest = std::max(largest, double(std::abs(sphere[2] - (scene.positions[i].z - moved))));
  }
  return largest;
}

TEST_P(StressCatalogue, Row27_FarFromTheOrigin) {
  const uint64_t steps = slow_steps(backend()) ? 1000 : 10'000;
  for (float distance : {1e5f, 1e6f, 1e7f}) {
    for (MotionMethod method : {MotionMethod::paper, MotionMethod::impact, MotionMethod::anchored})
      for (Precision precision : {Precision::compensated, Precision::float64}) {
        const double error = displacement_error(backend(), distant_scene({method, precision}, distance), steps);
        if (distance == 1e7f && method == MotionMethod::impact)
          note_figure(fmt::format("{} {:.1e} m at 1e7", precision_name(precision), error), "1e-4 m");
        EXPECT_LE(error, 1e-4) << motion_name(method) << ", " << precision_name(precision) << " at " << distance;
      }
    const Scene stalling = distant_scene({MotionMethod::paper, Precision::float32}, distance);
    EXPECT_NEAR(displacement_error(backend(), stalling, 1000), 1, 1e-3) << "float32 does not move there at all";
    EXPECT_EQ(stalled_spheres(stalling), 2u);
    const Scene anchored = distant_scene({MotionMethod::anchored, Precision::float32}, distance);
    EXPECT_LE(displacement_error(backend(), anchored, steps), double(distance) * 0x1p-23);
    EXPECT_EQ(stalled_spheres(anchored), 0u);
  }
  EXPECT_EQ(stalled_spheres(distant_scene({MotionMethod::paper, Precision::float32}, 100)), 0u);
  Scene turning = make_scene({.n = 1});
  turning.motion = {MotionMethod::paper, Precision::float32};
  turning.velocities[0] = {0, 1e-9f, 0, 0};
  EXPECT_EQ(stalled_spheres(turning), 0u) << "gravity moves on what is about to turn";
}

}  // namespace
}  // namespace spherepair
