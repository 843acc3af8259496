// SPDX-License-Identifier: MIT
// Draws the edges of a box into an image on the host, with the same bits for every backend, or gives them as lines.
#pragma once

#include <vector>

#include "common/image/canvas.h"
#include "common/scene/camera.h"

namespace spherepair {

// Draws the twelve edges as antialiased lines, hidden behind nearer surfaces. ahead: distance of each pixel's surface
// along forward, metres.
void draw_edges(std::vector<uint>& image, const std::vector<double>& ahead, const View& view, const Bounds& box);

struct EdgeLine {
  Point a, b;
  bool behind;  // the edge is behind the box: spheres in the box may hide it
};
std::vector<EdgeLine> edge_lines(const View& view, const Bounds& box);  // the edges in front of the camera

constexpr uint edge_colour = 0x707070;
double edge_thickness(uint height);  // pixels, of an image of this height

}  // namespace spherepair
