// SPDX-License-Identifier: MIT
// Where a bouncing sphere really is: the closed form in quadruple precision from the scene's float32 numbers. Flights
// last 2v/|g|, each bounce leaves e times the speed, and after Zeno's time the sphere rests.
#pragma once

#include <array>

#include "common/backend/backend.h"

namespace spherepair {

// Metres and metres per second: x, y, z, then the velocity.
using ExactState = std::array<long double, 6>;

// Sphere i of a backend's state with all the bits that the motion keeps.
ExactState exact_state(const Backend::State& state, MotionOptions motion, uint64_t i);

// How far sphere i is from its place in the closed form after so many steps of scene.dt: metres; and the share of its
// energy at the start (of speed and height above the plane, along y) that it has gained.
struct MotionError {
  double position, energy;
};
MotionError error_of(const Scene& scene, uint64_t i, uint64_t steps, const ExactState& state);

// Over all spheres: root mean square and largest error of position, largest gain or loss of energy.
struct MotionErrors {
  double rms = 0, largest = 0, energy = 0;
};
MotionErrors errors_of(const Scene& scene, uint64_t steps, const Backend::State& state);

}  // namespace spherepair
