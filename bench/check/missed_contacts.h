// SPDX-License-Identifier: MIT
// Contacts between steps: spheres that pass through each other, and the share of them that a test once a step misses,
// measured and expected.
#pragma once

#include "common/backend/backend.h"

namespace spherepair {

// Pairs of spheres, 2k and 2k + 1, that pass through each other on straight lines at a hashed distance and phase,
// without gravity, in steps of 1 s. `step_length`: distance moved per step, in sums of the radii.
Scene passing_scene(uint64_t pairs, double step_length, uint64_t seed);

// The share of these pairs that touch at no step: s^2/12 for s = step_length <= 2, 1 - 4/(3 s) above.
double expected_miss_share(double step_length);

// The number of pairs never found to touch, tested at every step, or within every step if `swept`.
uint64_t missed_pairs(Backend& backend, const Scene& scene, double step_length, bool swept);

}  // namespace spherepair
