// SPDX-License-Identifier: MIT
// The bounds of an image's or a video's spheres, and the place of the ground.
#pragma once

#include "bench/formats/start.h"
#include "common/scene/camera.h"

namespace spherepair {

// The bounds of the first image's spheres, or of all starts if they are the frames of a video.
Bounds bounds_of_all(const std::vector<Start>& starts, std::span<const vec4> spheres);

// wanted: none; plane: the scene's, the default for spheres that move; lowest: below the lowest sphere of all starts
// along `up`, the default for others; or a height along `up` in metres. spheres: the first image's.
void place_ground(Look& look, const std::string& wanted, const std::vector<Start>& starts,
                  std::span<const vec4> spheres, const Vector& up);

}  // namespace spherepair
