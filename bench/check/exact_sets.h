// SPDX-License-Identifier: MIT
// Reference sets: pairs of spheres whose positions are known to more than float32. All are in canonical order; spheres
// collide when |a - b|^2 < (ra + rb)^2 in quadruple precision.
#pragma once

#include "common/backend/backend.h"

namespace spherepair {

// Of the closed form's positions after so many steps.
std::vector<Pair> closed_form_pairs(const Scene& scene, uint64_t steps);

// Of a state's positions in its full precision.
std::vector<Pair> state_pairs(const Scene& scene, const Backend::State& state);

// Of the scene's positions, every coordinate moved by `distance` metres and stored in this precision.
std::vector<Pair> stored_pairs(const Scene& scene, double distance, Precision precision);

// The difference of a set from the right one, in numbers of pairs.
struct SetError {
  uint64_t right = 0, missed = 0, extra = 0;  // right: of the right set
  bool operator==(const SetError&) const = default;
};
SetError set_error(std::span<const Pair> found, std::span<const Pair> right);

}  // namespace spherepair
