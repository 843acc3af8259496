// SPDX-License-Identifier: MIT
// Draws legends and edges over an image, blended per pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/shared/layout.h"

namespace spherepair {

struct Point {
  double x, y;  // pixels, from the centre of the upper left one
};

// Draws over an image in the format of Drawing::image().
class Canvas {
 public:
  Canvas(std::vector<uint>& image, uint width, uint height) : image_(image), width_(width), height_(height) {}

  void blend(int x, int y, uint colour, double share);  // 0xRRGGBB over a pixel, covering a share of it
  void square(Point corner, double side, uint colour);

  // A line with round ends; shows(x, y, along): whether it is visible at a pixel, `along` from a (0) to b (1).
  template <typename Shows>
  void stroke(Point a, Point b, double thickness, uint colour, Shows shows);
  void stroke(Point a, Point b, double thickness, uint colour) {
    stroke(a, b, thickness, colour, [](int, int, double) { return true; });
  }

 private:
  std::vector<uint>& image_;
  uint width_, height_;
};

template <typename Shows>
void Canvas::stroke(Point a, Point b, double thickness, uint colour, Shows shows) {
  const double reach = thickness / 2 + 1, dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const int first_y = int(std::max(std::min(a.y, b.y) - reach, 0.0)),
            first_x = int(std::max(std::min(a.x, b.x) - reach, 0.0));
  const int last_y = int(std::min(std::max(a.y, b.y) + reach, height_ - 1.0)),
            last_x = int(std::min(std::max(a.x, b.x) + reach, width_ - 1.0));
  for (int y = first_y; y <= last_y; ++y)
    for (int x = first_x; x <= last_x; ++x) {
      const double along = square > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0;
      const double away = std::hypot(x - a.x - along * dx, y - a.y - along * dy);
      const double share = std::clamp(thickness / 2 + 0.5 - away, 0.0, 1.0);
      if (share > 0 && shows(x, y, along)) blend(x, y, colour, share);
    }
}

}  // namespace spherepair
