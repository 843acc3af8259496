// SPDX-License-Identifier: MIT
#include "common/image/canvas.h"

namespace spherepair {

void Canvas::blend(int x, int y, uint colour, double share) {
  if (x < 0 || y < 0 || x >= int(width_) || y >= int(height_)) return;
  uint& pixel = image_[size_t(y) * width_ + size_t(x)];
  uint mixed = 0xFF000000u;
  for (int channel = 0; channel < 3; ++channel) {
    const double there = pixel >> 8 * channel & 255, wanted = colour >> (16 - 8 * channel) & 255;
    mixed |= uint(std::lround(there + (wanted - there) * share)) << 8 * channel;
  }
  pixel = mixed;
}

void Canvas::square(Point corner, double side, uint colour) {
  for (int y = int(corner.y); y < int(corner.y + side); ++y)
    for (int x = int(corner.x); x < int(corner.x + side); ++x) blend(x, y, colour, 1);
}

}  // namespace spherepair
