// SPDX-License-Identifier: MIT
// Draws the edges of a box into an image on the host, with the same bits for every backend.
#pragma once

#include <vector>

#include "common/image/canvas.h"
#include "common/scene/camera.h"

namespace spherepair {

// Draws the twelve edges as antialiased lines, hidden behind nearer surfaces. ahead: distance of each pixel's surface
// along forward, metres.
void draw_edges(std::vector<uint>& image, const std::vector<double>& ahead, const View& view, const Bounds& box);

}  // namespace spherepair
