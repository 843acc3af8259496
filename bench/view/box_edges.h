// SPDX-License-Identifier: MIT
// Draws the edges of a box into an image on the host, so that they are the same for every backend.
#pragma once

#include <optional>
#include <vector>

#include "common/scene/camera.h"

namespace spherepair {

// Draws the twelve edges as antialiased lines, hidden by nearer spheres (`visible` of the same image and view) and by
// the ground plane at height `ground`, metres.
void draw_edges(std::vector<uint>& image, const std::vector<uvec2>& visible, const View& view, const Bounds& box,
                std::optional<float> ground);

}  // namespace spherepair
