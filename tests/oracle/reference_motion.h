// SPDX-License-Identifier: MIT
// The method `paper` independently of motion.h: every operation in rational numbers, then rounded to float32.
#pragma once

#include "common/backend/backend.h"
#include "common/shared/motion.h"

namespace spherepair {

// The parameters for motion.h, for a scene whose dt is a power of two: all products are then exact.
MotionParams reference_params(const Scene& scene);

struct Moved {
  vec4 position, velocity;
};

// One step in GMP rationals, each operation rounded to the nearest float32, ties to even.
Moved step_rational(vec4 position, vec4 velocity, const MotionParams& params);

// The same step with motion.h itself.
Moved step_paper(vec4 position, vec4 velocity, const MotionParams& params);

// One step of all spheres with motion.h itself, for long runs against the backends.
void step_all(const Scene& scene, Motion::State& state);

}  // namespace spherepair
