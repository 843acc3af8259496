// SPDX-License-Identifier: MIT
// What kernels are told of a scene.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

// The parameters of every kernel for this scene. All constants are computed here once, in float64, and rounded.
Params scene_params(const Scene& scene, bool exact);

}  // namespace spherepair
