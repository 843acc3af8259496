// SPDX-License-Identifier: MIT
// The closed form of a bouncing sphere's motion, in quadruple precision from the scene's float32 numbers. A flight
// lasts 2v/|g|, a bounce multiplies the speed by e, and after infinitely many bounces (Zeno's time) the sphere rests.
#pragma once

#include <array>

#include "common/backend/motion.h"

namespace spherepair {

// Metres and metres per second: x, y, z, then the velocity.
using ExactState = std::array<long double, 6>;

// Sphere i of a backend's state in the motion's full precision.
ExactState exact_state(const Motion::State& state, MotionOptions motion, uint64_t i);

// Distance of sphere i from the closed form after so many steps of scene.dt, in metres, and its relative gain of energy
// (of vertical speed and height above the plane) since the start.
struct MotionError {
  double position, energy;
};
MotionError error_of(const Scene& scene, uint64_t i, uint64_t steps, const ExactState& state);

// Over all spheres: root mean square and maximum of the position error, largest change of energy.
struct MotionErrors {
  double rms = 0, largest = 0, energy = 0;
};
MotionErrors errors_of(const Scene& scene, uint64_t steps, const Motion::State& state);

}  // namespace spherepair
