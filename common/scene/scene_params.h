// SPDX-License-Identifier: MIT
// What kernels are told of a scene.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

// Constants are computed here once, in float64, and rounded.
MotionParams motion_params(const Scene& scene);              // at the start: no step is done
SearchParams search_params(const Scene& scene, bool exact);  // of the predicate; a launch adds the rest
float common_radius(const Scene& scene);                     // 0 where radii differ

}  // namespace spherepair
