// SPDX-License-Identifier: MIT
// Counts pairs that the rounding of a file's numbers to float32 may have decided.
#pragma once

#include <string>

#include "bench/spheres/rounding.h"
#include "common/backend/search.h"

namespace spherepair {

// Counts the pairs that are closer to touching than rounding can move them. These include all pairs that differ between
// the file's numbers and the rounded ones. Searches twice, with radii larger and smaller by the reach; the backend then
// holds other spheres.
uint64_t pairs_within_reach(Search& search, const Scene& scene, const Rounding& rounding,
                            const CollideOptions& options);

// A warning for the user; empty without such pairs. of_points: pairs of points, whose distance is near the cutoff.
std::string reach_warning(uint64_t pairs, const Rounding& rounding, bool of_points = false);

}  // namespace spherepair
