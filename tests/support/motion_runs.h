// SPDX-License-Identifier: MIT
// Shared by tests of the motion methods: scenes that bounce, and running a backend through them.
#pragma once

#include "bench/check/closed_form.h"
#include "tests/support/backends.h"

namespace spherepair {

struct BouncingOptions {
  MotionOptions motion;
  float dt = 0x1p-6f, restitution = 1;
  uint64_t n = 100;
};

// The paper's first animation: heights up to 20 m above the plane, vertical speeds up to 5 m/s.
Scene bouncing_scene(const BouncingOptions& options);

// The same with positions, speeds, radii and directions of every size, and spheres at rest on the plane and below it.
Scene awkward_scene(const BouncingOptions& options);

// The state after `steps` steps from the scene.
Motion::State run_steps(Motion& motion, const Scene& scene, uint64_t steps);

Backend& cpu_backend();

// Fails if the states differ in any bit, and names the first sphere and the place in the wide state.
void expect_equal_states(const Motion::State& given, const Motion::State& wanted, const std::string& where);

constexpr Precision PRECISIONS[] = {Precision::float32, Precision::compensated, Precision::float64};

}  // namespace spherepair
