// SPDX-License-Identifier: MIT
// Reference sets: pairs of spheres whose positions have more digits than float32. All are in canonical order; spheres
// collide when |a - b|^2 < (ra + rb)^2 in quadruple precision.
#pragma once

#include "common/backend/motion.h"
#include "common/scene/pair_set.h"

namespace spherepair {

// Pairs of the closed form's positions after so many steps.
std::vector<Pair> closed_form_pairs(const Scene& scene, uint64_t steps);

// Pairs of a state's positions in full precision.
std::vector<Pair> state_pairs(const Scene& scene, const Motion::State& state);

// Pairs of the scene's positions, every coordinate moved by `distance` metres and stored in this precision.
std::vector<Pair> stored_pairs(const Scene& scene, double distance, Precision precision);

// The difference of a set from the correct one, in pairs.
struct SetError {
  uint64_t right = 0, missed = 0, extra = 0;  // right: pairs of the correct set
  bool operator==(const SetError&) const = default;
};
SetError set_error(std::span<const Pair> found, std::span<const Pair> right);

}  // namespace spherepair
