// SPDX-License-Identifier: MIT
// The CPU's search through the grid. It keeps its memory from call to call.
#pragma once

#include "common/cpu/search/cpu_grid_sort.h"
#include "common/cpu/search/cpu_pair_list.h"
#include "common/cpu/search/cpu_pairs.h"

namespace spherepair {

class CpuGrid {
 public:
  explicit CpuGrid(const GridSimd& simd = grid_simds().front()) : simd_(simd), cells_(simd) {}

  // Finds everything but counts(), which orders the counts by sphere when asked. keep_cells: the spheres are those of
  // the last search, in the same cells.
  PairsFound search(const SearchInput& search, const GridPlan& plan, bool keep_cells);
  std::vector<uint> counts(int threads) const;  // of the last search

 private:
  class Finder;

  Collisions find(const SearchInput& search, const Params& p);
  uint64_t join_counts(int threads);

  const GridSimd& simd_;
  CellSort cells_;
  uint64_t n_ = 0;
  Buffer<uint> near_counts_, far_counts_;  // contacts by sorted index: within the sphere's own chunk, and in others
  std::vector<GrowingList<uint64_t>> lists_;
  PairSort list_sort_;
};

}  // namespace spherepair
