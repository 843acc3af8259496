// SPDX-License-Identifier: MIT
// The edges of a box in a picture: drawn here, from numbers that are the same on every backend.
#pragma once

#include <optional>
#include <vector>

#include "common/scene/camera.h"

namespace spherepair {

// The twelve edges as antialiased lines, behind what the picture shows nearer: `visible` is that of the same picture,
// of the view; `ground` the height of the plane that hides too, metres.
void draw_edges(std::vector<uint>& image, const std::vector<uvec2>& visible, const View& view, const Bounds& box,
                std::optional<float> ground);

}  // namespace spherepair
