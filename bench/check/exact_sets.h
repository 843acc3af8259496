// SPDX-License-Identifier: MIT
// Pairs of spheres whose places are known better than float32 can say: the sets that found ones are measured against.
// All are in canonical order; spheres collide when |a - b|^2 < (ra + rb)^2 in quadruple precision.
#pragma once

#include "common/backend/backend.h"

namespace spherepair {

// Where the closed form has the scene's spheres after so many steps.
std::vector<Pair> closed_form_pairs(const Scene& scene, uint64_t steps);

// Where a state of this scene has them with all the bits that its precision keeps.
std::vector<Pair> state_pairs(const Scene& scene, const Backend::State& state);

// Where they stand, every coordinate moved by `distance` metres and then stored in this precision.
std::vector<Pair> stored_pairs(const Scene& scene, double distance, Precision precision);

// How a set differs from the right one, in numbers of pairs.
struct SetError {
  uint64_t right = 0, missed = 0, extra = 0;  // right: of the right set
  bool operator==(const SetError&) const = default;
};
SetError set_error(std::span<const Pair> found, std::span<const Pair> right);

}  // namespace spherepair
