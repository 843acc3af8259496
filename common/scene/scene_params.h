// SPDX-License-Identifier: MIT
// The constants of a scene that kernels read.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

// All are computed in float64 and rounded once.
MotionParams motion_params(const Scene& scene);              // at the start, before any step
SearchParams search_params(const Scene& scene, bool exact);  // for the predicate; a launch adds the rest
float common_radius(const Scene& scene);                     // 0 if radii differ

}  // namespace spherepair
