// SPDX-License-Identifier: MIT
// When Method::automatic takes the grid, and when which way of all pairs. Only speed depends on it, never the set. The
// figures are those of `spherepair crossover`; bench/NOTES.md says on which machine they were measured.
#pragma once

#include <cmath>

#include "layout.h"

namespace spherepair {

struct Crossover {
  const char* device;  // a backend, OpenGL in software, or a CPU of more than few_threads
  uint64_t grid_from;  // spheres from which on the grid is ahead where none shares a cell; of radii in several levels,
                       // so many each
  uint64_t square_to;  // up to so many spheres collide_square is ahead of collide_triangle
  uint64_t per_other;  // and so many more for each other sphere in a sphere's cell
  uint64_t wide_from;  // spheres from which on collide_grid is faster in groups of wide_block, on devices
  uint64_t few;        // up to so many spheres the grid is ahead as well, where there is no crowd, but ...
  double contacts_least;         // ... so many contacts or more, about
  double crowd_from = HUGE_VAL;  // others in a cell from which on the grid is ahead of crowd_least spheres or more:
                                 // all pairs settles each near pair by itself
  uint64_t one_cell_to = 0;      // but not of more than so many where most of them stand in one cell
};
constexpr uint wide_block = 256;
constexpr uint64_t crowd_least = 32;
constexpr int few_threads = 4;
constexpr uint64_t never = ~uint64_t(0);
constexpr Crossover crossovers[] = {{"cuda", 3600, 4900, 400, 4'000'000, 512, 8},
                                    {"glsl", 4700, 5200, 350, never, 200, 100},
                                    {"glsl in software", 480, 0, 50, never, 0, 0},
                                    {"cpu", 2000, 0, 50, never, 0, 0, 1.5, never},
                                    {"cpu of many threads", 7000, 0, 50, never, 0, 0, 2.2, 1024}};

// Whatever the spheres' cells are like, in rows without crowd_from.
constexpr bool may_take_grid(const Crossover& row, uint64_t n) { return n <= row.few || n >= row.grid_from; }

// The spheres from which on the grid is ahead with so many others in a sphere's cell on average and levels of cells.
constexpr double grid_from(const Crossover& row, double others_in_cell, uint levels) {
  return double(row.grid_from * levels) + others_in_cell * double(row.per_other);
}
constexpr bool grid_pays(const Crossover& row, uint64_t n, double others_in_cell, uint levels) {
  const bool one_cell = 4 * others_in_cell > double(n);
  if (n >= crowd_least && others_in_cell >= row.crowd_from && (n <= row.one_cell_to || !one_cell)) return true;
  if (n <= row.few && others_in_cell * double(n) >= row.contacts_least && others_in_cell <= 4) return true;
  return double(n) >= grid_from(row, others_in_cell, levels);
}

// Between the two ways of all pairs. Where most spheres stand in one cell, nearly all pairs are near, which
// collide_triangle queues one by one.
constexpr bool square_pays(const Crossover& row, uint64_t n, double others_in_cell) {
  return n <= row.square_to || (row.square_to > 0 && 4 * others_in_cell > double(n));
}

}  // namespace spherepair
