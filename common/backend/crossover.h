// SPDX-License-Identifier: MIT
// When Method::automatic takes the grid, and which all-pairs method it takes otherwise. This changes the speed, never
// the set. The figures are fitted to `spherepair crossover`; docs/NOTES/crossover.md has the data, the machines and the
// loss against the best choice.
#pragma once

#include <algorithm>

#include "common/shared/layout.h"

namespace spherepair {

constexpr uint64_t never = ~uint64_t(0);

struct Crossover {
  const char* device;             // a backend, a backend "in software", or "cpu of many threads" (over few_threads)
  double grid_from, per_other;    // dense cells are faster from so many spheres on, plus per_other for each other
                                  // sphere in a sphere's cell; negative on a CPU, whose vectors like full cells
  double hashed_from, per_level;  // the same for hashed cells, plus per_level for each level after the first; negative
                                  // per_other counts as 0
  uint64_t narrow_to = 0;         // up to this many spheres collide_square is faster in groups of narrow_block
  uint64_t wide_from = never;     // from this many spheres on collide_grid uses groups of wide_block
};
// grid_from, per_other, hashed_from, per_level, narrow_to, wide_from
constexpr Crossover crossovers[] = {
    {"cuda", 5000, 250, 15'500, 17'000, 2100, 4'000'000},
    {"opengl", 7500, 310, 15'500, 17'000, 2100},
    {"vulkan", 7500, 310, 15'500, 17'000, 2100},  // OpenGL's figures: not measured yet
    {"vulkan in software", 200, 2, 300, 600, 100},
    {"opengl in software", 200, 2, 300, 600, 100},
    {"cpu", 400, -200, 4000, 2500},
    {"cpu of many threads", 400, -200, 20'000, 3000},
};
constexpr uint narrow_block = 32, square_block = 64, wide_block = 256;
constexpr double least_spheres = 32;  // that a grid pays for
constexpr int few_threads = 4;

// Returns the number of spheres from which on the grid is faster. others_in_cell: mean number of other spheres in a
// sphere's cell; hashed_levels: levels of hashed cells, 0 for dense cells.
constexpr double grid_from(const Crossover& row, double others_in_cell, uint hashed_levels) {
  if (hashed_levels == 0) return std::max(least_spheres, row.grid_from + row.per_other * others_in_cell);
  return row.hashed_from + row.per_level * (hashed_levels - 1) + std::max(row.per_other, 0.0) * others_in_cell;
}

// Whether most pairs are near. If so, collide_square, which tests near pairs in its loop, is faster than
// collide_triangle, which queues them. others_like_it: mean number of others in a sphere's hashed cell, whose size
// suits its radius.
constexpr bool most_pairs_near(uint64_t n, double others_like_it) {
  constexpr double free_others = 10, spheres_per_other = 140;
  return double(n) <= spheres_per_other * (others_like_it - free_others);
}

}  // namespace spherepair
