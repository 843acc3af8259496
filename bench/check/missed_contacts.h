// SPDX-License-Identifier: MIT
// Contacts between steps: spheres that pass through each other, how many of them a test once a step never sees, and how
// many geometry says it misses.
#pragma once

#include "common/backend/backend.h"

namespace spherepair {

// Pairs of spheres, 2k and 2k + 1, that pass each other on straight lines through one another, at a hashed distance and
// phase, without gravity, in steps of 1 s. `way` is what they move in a step over the sum of their radii.
Scene passing_scene(uint64_t pairs, double way, uint64_t seed);

// The share of them that touch at no step: way^2/12 up to 2, 1 - 4/(3 way) above.
double expected_miss_share(double way);

// How many are never seen to touch, tested at every step, or within every step when `swept`.
uint64_t missed_pairs(Backend& backend, const Scene& scene, double way, bool swept);

// The method of the swept test on this backend.
Method swept_method(const Backend& backend);

}  // namespace spherepair
