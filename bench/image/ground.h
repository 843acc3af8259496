// SPDX-License-Identifier: MIT
// Where the camera of one image or of a whole video finds its spheres and their ground.
#pragma once

#include "bench/formats/start.h"
#include "common/scene/camera.h"

namespace spherepair {

// Of the first image's spheres, and of all starts where they are the frames of a video.
Bounds bounds_of_all(const std::vector<Start>& starts, std::span<const vec4> spheres);

// wanted: none; plane, the scene's, the default of spheres that move; lowest, below the lowest sphere of all starts
// along `up`, the default of others; or a height along `up`, metres. spheres: the first image's.
void place_ground(Look& look, const std::string& wanted, const std::vector<Start>& starts,
                  std::span<const vec4> spheres, const Vector& up);

}  // namespace spherepair
