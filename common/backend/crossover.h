// SPDX-License-Identifier: MIT
// When Method::automatic takes the grid, and when which way of all pairs. Only speed depends on it, never the set. The
// figures are those of `spherepair crossover`; docs/NOTES/crossover.md has them and their machines.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/shared/layout.h"

namespace spherepair {

// Spheres from which on hashed cells are ahead: so many, and more for each other sphere in a sphere's cell and for each
// level of cells after the first.
struct HashedFrom {
  double spheres, per_other, per_level;
};

// From so many others in a sphere's hashed cell on, which is made for radii like its own, collide_square is ahead of
// collide_triangle: up to so many spheres for each of them.
struct NearPairs {
  double others = HUGE_VAL, spheres_per_other = 0;
};

constexpr uint64_t never = ~uint64_t(0);

struct Crossover {
  const char* device;                // a backend, OpenGL in software, or a CPU of more than few_threads
  uint64_t grid_from;                // spheres from which on the grid of dense cells is ahead
  double free_others = 0;            // in a sphere's cell, that cost nothing; of more than these ...
  double per_other = 0, growth = 1;  // ... so many spheres more, times those above to this power
  HashedFrom hashed;
  NearPairs near = {};       // of few spheres, which collide_triangle queues one by one
  uint64_t square_to = 0;    // up to so many spheres collide_square is ahead of it whatever is near
  double occupancy_of;       // where others times this exceed the spheres, most pairs are near: the grid has
                             // nothing to leave out ...
  uint64_t one_cell_to = 0;  // ... which the grid can bear up to so many spheres
  uint64_t narrow_to = 0;    // up to so many spheres collide_square is fastest in groups of narrow_block, up to
                             // square_block_to of square_block
  uint64_t square_block_to = 0;
  uint64_t wide_from = never;        // spheres from which on collide_grid is faster in groups of wide_block
  double occupancy_from = HUGE_VAL;  // others in a dense cell from which on the grid is ahead of least_crowded spheres
                                     // or more: all pairs handles each near pair by itself
};
constexpr uint narrow_block = 32, square_block = 64, wide_block = 256;
constexpr uint64_t least_crowded = 32;
constexpr int few_threads = 4;
constexpr Crossover crossovers[] = {{.device = "cuda",
                                     .grid_from = 5600,
                                     .free_others = 1.3,
                                     .per_other = 2900,
                                     .growth = 0.349,
                                     .hashed = {8500, 2300, 17'700},
                                     .near = {10, 120},
                                     .occupancy_of = 22,
                                     .narrow_to = 2100,
                                     .square_block_to = 6500,
                                     .wide_from = 4'000'000},
                                    {.device = "glsl",
                                     .grid_from = 5100,
                                     .free_others = 1.3,
                                     .per_other = 3340,
                                     .growth = 0.479,
                                     .hashed = {12'500, 1540, 14'800},
                                     .near = {10, 120},
                                     .occupancy_of = 26,
                                     .narrow_to = 2100,
                                     .square_block_to = 6500},
                                    {.device = "glsl in software",
                                     .grid_from = 200,
                                     .hashed = {300, 0, 700},
                                     .near = {10, 40},
                                     .square_to = 500,
                                     .occupancy_of = 4,
                                     .one_cell_to = 200,
                                     .narrow_to = 100,
                                     .square_block_to = 1000},
                                    {.device = "cpu",
                                     .grid_from = 2000,
                                     .per_other = 50,
                                     .hashed = {4000, 0, 2500},
                                     .occupancy_of = 4,
                                     .one_cell_to = never,
                                     .occupancy_from = 1.5},
                                    {.device = "cpu of many threads",
                                     .grid_from = 7000,
                                     .per_other = 50,
                                     .hashed = {20'000, 0, 3000},
                                     .occupancy_of = 4,
                                     .one_cell_to = 1024,
                                     .occupancy_from = 2.2}};

// Whatever the spheres' cells are like, in rows without occupancy_from.
constexpr bool may_take_grid(const Crossover& row, uint64_t n) { return n >= row.grid_from; }

// The spheres from which on the grid is ahead with so many others in a sphere's cell on average. Levels of hashed
// cells; 0: cells are dense.
inline double grid_from(const Crossover& row, double others_in_cell, uint hashed_levels) {
  const HashedFrom& hashed = row.hashed;
  if (hashed_levels != 0)
    return hashed.spheres + hashed.per_other * others_in_cell + hashed.per_level * (hashed_levels - 1);
  return double(row.grid_from) + row.per_other * std::pow(std::max(others_in_cell - row.free_others, 0.0), row.growth);
}
constexpr bool most_pairs_near(const Crossover& row, uint64_t n, double others_in_cell) {
  return row.occupancy_of * others_in_cell > double(n) && n > row.one_cell_to;
}
constexpr bool occupancy_pays(const Crossover& row, uint64_t n, double others_in_cell, uint hashed_levels) {
  return hashed_levels == 0 && n >= least_crowded && others_in_cell >= row.occupancy_from;
}
inline bool grid_pays(const Crossover& row, uint64_t n, double others_in_cell, uint hashed_levels) {
  if (most_pairs_near(row, n, others_in_cell)) return false;
  return occupancy_pays(row, n, others_in_cell, hashed_levels) ||
         double(n) >= grid_from(row, others_in_cell, hashed_levels);
}

// Between the two ways of all pairs; others in a sphere's hashed cell.
constexpr bool square_pays(const Crossover& row, uint64_t n, double others_like_it) {
  return n <= row.square_to ||
         (others_like_it >= row.near.others && double(n) <= row.near.spheres_per_other * others_like_it);
}

}  // namespace spherepair
