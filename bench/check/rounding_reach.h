// SPDX-License-Identifier: MIT
// Which pairs the rounding of a file's numbers to float32 can have decided.
#pragma once

#include <string>

#include "bench/spheres/rounding.h"
#include "common/backend/backend.h"

namespace spherepair {

// Counts the pairs that rounding may have decided, within the reach of touching: those that differ between the file's
// numbers and the rounded ones are among them. Searches twice, with radii larger and smaller by the reach; the backend
// then holds other spheres.
uint64_t pairs_within_reach(Backend& backend, const Scene& scene, const Rounding& rounding,
                            const CollideOptions& options);

// A warning for the user; empty without such pairs. of_points: pairs of points, whose distance is near the cutoff.
std::string reach_warning(uint64_t pairs, const Rounding& rounding, bool of_points = false);

}  // namespace spherepair
