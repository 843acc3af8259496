// SPDX-License-Identifier: MIT
// When Method::automatic takes the grid, and when which way of all pairs. Only speed depends on it, never the set. The
// figures are those of `spherepair crossover`; bench/NOTES.md says on which machine they were measured.
#pragma once

#include "layout.h"

namespace spherepair {

struct Crossover {
  const char* device;    // a backend, or OpenGL in software
  uint64_t grid_from;    // spheres from which on the grid is ahead in a gas; of radii in several levels, so many each
  uint64_t square_to;    // up to so many spheres collide_square is ahead of collide_triangle
  uint64_t one_cell_of;  // a cell must not hold more than one sphere of so many: else nearly all pairs are met anyway
  uint64_t wide_from;    // spheres from which on collide_grid is faster in groups of wide_block, on devices
};
constexpr uint wide_block = 256;
constexpr uint64_t never = ~uint64_t(0);
constexpr Crossover crossovers[] = {{"cuda", 2048, 1024, 200, 4'000'000},
                                    {"glsl", 8192, 1024, 200, never},
                                    {"glsl in software", 512, 0, 50, never},
                                    {"cpu", 2048, 0, 50, never}};

// n spheres, so many others in a sphere's cell on average, so many levels of cells.
constexpr bool grid_pays(const Crossover& row, uint64_t n, double others_in_cell, uint levels) {
  return n >= row.grid_from * levels && others_in_cell * double(row.one_cell_of) <= double(n);
}

}  // namespace spherepair
