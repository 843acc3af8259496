// SPDX-License-Identifier: MIT
// The table of cells where it is longer than a texture buffer may be: parts of it, each for the spheres of its own
// cells and long enough for their neighbourhoods, so that one dispatch a part reads one texture each.
#pragma once

#include <algorithm>

#include "layout.h"

namespace spherepair {

struct TableWindows {
  uint64_t words = 0;    // of the whole table: of each cell, the end of the last, and one more
  uint64_t longest = 0;  // words of a texture
  uint64_t step = 0;     // cells whose spheres a dispatch takes; 0: a neighbourhood does not fit

  uint64_t cells() const { return words - 2; }
  uint64_t count() const { return step ? (cells() + step - 1) / step : 0; }
  uint64_t first(uint64_t k) const { return k * step; }  // cell, and where the texture begins
  uint64_t behind(uint64_t k) const { return std::min(first(k + 1), cells()); }
  uint64_t readable(uint64_t k) const { return std::min(longest, words - first(k)); }
};

// Of a dense grid, for textures of at most so many words. Windows begin at multiples of 256 bytes, the most that GL
// lets a driver ask for.
inline TableWindows table_windows(const Params& p, uint64_t longest) {
  constexpr uint64_t alignment = 256 / sizeof(uint);
  TableWindows windows{uint64_t(p.cell_slots) + 2, longest};
  // A sphere reads where its rows of cells begin and end, up to a cell behind that right of it in the next layer's row.
  const uint64_t ahead = uint64_t(p.cells_x) * p.cells_y + p.cells_x + 2;
  if (windows.words <= longest) {
    windows.step = windows.words;
  } else if (2 * ahead <= longest) {  // else most of each window would be there for neighbours
    windows.step = (longest - ahead) / alignment * alignment;
  }
  return windows;
}

}  // namespace spherepair
