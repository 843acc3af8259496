// SPDX-License-Identifier: MIT
// Whether spheres of consecutive numbers stand side by side, as those of a simulation do that began in cell order. A
// sort by counting then writes to a few places at a time, and needs no buckets.
#pragma once

#include <vector>

#include "grid_plan.h"

namespace spherepair {

// By a sample of the spheres; false for those that the plan puts into hashed cells, which are side by side nowhere.
bool numbers_follow_cells(const std::vector<vec4>& spheres, const GridPlan& plan);

}  // namespace spherepair
