// SPDX-License-Identifier: MIT
#include "bench/view/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "bench/view/canvas.h"

namespace spherepair {
namespace {

// Polylines of points, each a digit for x (0 to 4) and one for y (0 at the baseline, 6 at cap height).
const std::map<char, std::string> glyphs = {{'.', "20 20"},
                                            {'-', "03 43"},
                                            {'/', "00 46"},
                                            {'<', "45 03 41"},
                                            {'0', "10 30 41 45 36 16 05 01 10"},
                                            {'1', "14 26 20"},
                                            {'2', "05 16 36 45 44 00 40"},
                                            {'3', "05 16 36 45 44 33 23/33 42 41 30 10 01"},
                                            {'4', "30 36 02 42"},
                                            {'5', "46 06 03 33 42 41 30 00"},
                                            {'6', "36 16 04 01 10 30 41 42 33 13 02"},
                                            {'7', "06 46 10"},
                                            {'8', "13 33 42 41 30 10 01 02 13 04 05 16 36 45 44 33"},
                                            {'9', "44 33 13 04 05 16 36 45 41 30 10"},
                                            {'+', "21 25/03 43"},
                                            {'a', "04 34 43 40 10 01 12 42"},
                                            {'c', "44 14 03 01 10 40"},
                                            {'e', "03 43 34 14 03 01 10 40"},
                                            {'m', "00 04/03 14 23 20/23 34 43 40"},
                                            {'n', "00 04/03 14 34 43 40"},
                                            {'o', "10 30 41 43 34 14 03 01 10"},
                                            {'s', "44 14 03 12 32 41 30 00"},
                                            {'t', "16 11 20 30/04 34"}};

// From the left end of the baseline; unit: a sixth of the cap height, pixels.
void write(Canvas& canvas, const std::string& words, Point foot, double unit, uint colour) {
  for (const char letter : words) {
    const std::string strokes = letter == ' ' ? "" : glyphs.at(letter);
    for (size_t k = 3; k < strokes.size(); k += 3) {
      if (strokes[k - 1] == '/') continue;
      const auto point = [&](size_t at) {
        return Point{foot.x + unit * (strokes[at] - '0'), foot.y - unit * (strokes[at + 1] - '0')};
      };
      canvas.stroke(point(k - 3), point(k), 0.9 * unit, colour);
    }
    foot.x += 6 * unit;
  }
}

}  // namespace

std::vector<std::string> legend_labels(const Look& look) {
  std::vector<std::string> labels;
  for (size_t k = 0; k < look.palette.size(); ++k) {
    if (look.colour_by == COLOUR_BY_CONTACTS) {
      labels.push_back(std::to_string(k));
    } else {
      labels.push_back(fmt::format("{}{:.3g}", k == 0 ? "< " : "", look.limits[k == 0 ? 0 : k - 1]));
    }
  }
  labels.back() += "+";
  return labels;
}

void draw_legend(std::vector<uint>& image, uint width, uint height, const Look& look) {
  const std::vector<std::string> labels = legend_labels(look);
  size_t longest = 0;
  for (const std::string& label : labels) longest = std::max(longest, label.size());
  const double unit = std::max(1.5, height / 360.0), side = 12 * unit;
  const double column = std::max(1.25 * side, (6 * double(longest) + 3) * unit);
  if (width < 11 * 1.5 * side || width < 2 * side + 8 * column || height < 6 * side) return;
  const uint ink = 0x404040;
  Canvas canvas(image, width, height);
  Point at = {std::max(side, (3 * double(labels[0].size()) - 5) * unit), height - 2.2 * side};
  write(canvas, std::array{"contacts", "m/s", "m"}[look.colour_by], {at.x, at.y - 0.7 * side}, unit, ink);
  for (size_t k = 0; k < labels.size(); ++k) {
    canvas.square(at, side, look.palette[k]);
    write(canvas, labels[k], {at.x + (7 - 3 * double(labels[k].size())) * unit, at.y + 1.8 * side}, unit, ink);
    at.x += column;
  }
}

}  // namespace spherepair
