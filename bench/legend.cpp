// SPDX-License-Identifier: MIT
#include "legend.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace spherepair {
namespace {

struct Point {
  double x, y;
};

// Strokes from point to point, each a digit for x (0 to 4) and one for y (0 at the foot, 6 at a capital's top).
const std::map<char, std::string> glyphs = {{'0', "10 30 41 45 36 16 05 01 10"},
                                            {'1', "14 26 20"},
                                            {'2', "05 16 36 45 44 00 40"},
                                            {'3', "05 16 36 45 44 33 23/33 42 41 30 10 01"},
                                            {'4', "30 36 02 42"},
                                            {'5', "46 06 03 33 42 41 30 00"},
                                            {'6', "36 16 04 01 10 30 41 42 33 13 02"},
                                            {'7', "06 46 10"},
                                            {'+', "21 25/03 43"},
                                            {'a', "04 34 43 40 10 01 12 42"},
                                            {'c', "44 14 03 01 10 40"},
                                            {'n', "00 04/03 14 34 43 40"},
                                            {'o', "10 30 41 43 34 14 03 01 10"},
                                            {'s', "44 14 03 12 32 41 30 00"},
                                            {'t', "16 11 20 30/04 34"}};

class Canvas {
 public:
  Canvas(std::vector<uint>& image, uint width, uint height) : image_(image), width_(width), height_(height) {}

  // Lays a colour (0xRRGGBB) over a pixel, covering a share of it.
  void blend(int x, int y, uint colour, double share) {
    if (x < 0 || y < 0 || x >= int(width_) || y >= int(height_)) return;
    uint& pixel = image_[size_t(y) * width_ + size_t(x)];
    uint mixed = 0xFF000000u;
    for (int channel = 0; channel < 3; ++channel) {
      const double there = pixel >> 8 * channel & 255, wanted = colour >> (16 - 8 * channel) & 255;
      mixed |= uint(std::lround(there + (wanted - there) * share)) << 8 * channel;
    }
    pixel = mixed;
  }

  void stroke(Point a, Point b, double thickness, uint colour) {
    const double reach = thickness / 2 + 1, dx = b.x - a.x, dy = b.y - a.y;
    for (int y = int(std::min(a.y, b.y) - reach); y <= int(std::max(a.y, b.y) + reach); ++y)
      for (int x = int(std::min(a.x, b.x) - reach); x <= int(std::max(a.x, b.x) + reach); ++x) {
        const double along = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        const double away = std::hypot(x - a.x - along * dx, y - a.y - along * dy);
        blend(x, y, colour, std::clamp(thickness / 2 + 0.5 - away, 0.0, 1.0));
      }
  }

  // From its left foot; unit: pixels of a sixth of a capital's height. Returns where the next text begins.
  double text(const std::string& words, Point foot, double unit, uint colour) {
    for (const char letter : words) {
      const std::string& strokes = glyphs.at(letter);
      for (size_t k = 3; k < strokes.size(); k += 3) {
        if (strokes[k - 1] == '/') continue;
        const auto point = [&](size_t at) {
          return Point{foot.x + unit * (strokes[at] - '0'), foot.y - unit * (strokes[at + 1] - '0')};
        };
        stroke(point(k - 3), point(k), 0.9 * unit, colour);
      }
      foot.x += 6 * unit;
    }
    return foot.x;
  }

  void square(Point corner, double side, uint colour) {
    for (int y = int(corner.y); y < int(corner.y + side); ++y)
      for (int x = int(corner.x); x < int(corner.x + side); ++x) blend(x, y, colour, 1);
  }

 private:
  std::vector<uint>& image_;
  uint width_, height_;
};

}  // namespace

void draw_legend(std::vector<uint>& image, uint width, uint height, const Look& look) {
  const double unit = std::max(1.5, height / 360.0), side = 12 * unit;
  if (width < 11 * 1.5 * side || height < 6 * side) return;
  const uint ink = 0x404040;
  Canvas canvas(image, width, height);
  Point at = {side, height - 2.2 * side};
  canvas.text("contacts", {at.x, at.y - 0.7 * side}, unit, ink);
  for (size_t k = 0; k < look.palette.size(); ++k) {
    const bool last = k + 1 == look.palette.size();
    canvas.square(at, side, look.palette[k]);
    canvas.text(std::to_string(k) + (last ? "+" : ""), {at.x + (last ? 1 : 4) * unit, at.y + 1.8 * side}, unit, ink);
    at.x += 1.25 * side;
  }
}

}  // namespace spherepair
