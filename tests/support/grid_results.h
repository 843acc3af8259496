// SPDX-License-Identifier: MIT
// Compares the CPU's grid with all pairs; makes steps of the grid on any backend.
#pragma once

#include "common/cpu/search/cpu_grid.h"
#include "tests/support/backends.h"

namespace spherepair {

const std::vector<Cells> both_cells = {Cells::dense, Cells::hashed};
inline const char* name_of(Cells cells) { return cells == Cells::dense ? "dense" : "hashed"; }

// A step that sorts anew, with other changes of the options.
template <typename Change>
CollideOptions grid_step(Change change) {
  CollideOptions options = {.method = Method::collide_grid, .grid = {.keep_order = false, .keep_cells = false}};
  change(options);
  return options;
}

SearchInput search_of(const Scene& scene, bool want_pairs, int threads);
StepResult result_of(CpuGrid& grid, const Scene& scene, Cells cells, bool want_pairs, int threads = 2);

// The difference of two answers; empty if both have the same set.
std::string difference(const StepResult& given, const PairsFound& wanted);

// The first mismatch of the grid with all pairs, by both kinds of cells and, for small scenes, every instruction set.
std::string first_grid_mismatch(const Scene& scene);

}  // namespace spherepair
