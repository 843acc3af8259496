// SPDX-License-Identifier: MIT
// The edges of a box: drawn into an image on the host, so that they are the same for every backend, or as lines over
// one.
#pragma once

#include <vector>

#include "bench/legend/canvas.h"
#include "common/scene/camera.h"

namespace spherepair {

// Draws the twelve edges as antialiased lines, hidden by what is nearer; ahead: distance of each pixel's surface along
// forward, metres.
void draw_edges(std::vector<uint>& image, const std::vector<double>& ahead, const View& view, const Bounds& box);

struct EdgeLine {
  Point a, b;
  bool behind;  // the box: spheres in it may hide it
};
std::vector<EdgeLine> edge_lines(const View& view, const Bounds& box);  // of those in front of the camera

constexpr uint edge_colour = 0x707070;
double edge_thickness(uint height);  // pixels, of an image of this height

}  // namespace spherepair
