// SPDX-License-Identifier: MIT
// A sorted list of pairs, row by row.
#pragma once

#include <vector>

#include "common/lists/displacement.h"
#include "common/lists/list_systems.h"
#include "common/scene/host_buffer.h"

namespace spherepair {

// Row i has the pairs of point (or query) i: offsets[i] to offsets[i + 1] - 1.
struct PairRows {
  std::vector<int64_t> offsets = {0};
  Buffer<uint32_t> second;
  Buffer<Shift> shifts;  // of each pair, if `shifted`; else all are 0, or nobody wants them
  bool shifted = false;

  int64_t count() const { return offsets.back(); }
  int64_t rows() const { return int64_t(offsets.size()) - 1; }
  Shift shift(int64_t k) const { return shifted ? shifts[size_t(k)] : Shift{}; }

  // Allocates rows of these lengths, of which offsets[i + 1] is row i's, and sums them up.
  void make_room(bool with_shifts);
  // Runs work(begin, end), which may not throw, for shares of the rows, of many pairs with several threads.
  template <typename Work>
  void in_rows(Work work) const {
    in_shares(0, rows(), rows() + count(), work);
  }
  // Runs work(row, k) for each pair k.
  template <typename Work>
  void for_pairs(Work work) const {
    in_rows([&](int64_t begin, int64_t end) {
      for (int64_t row = begin; row < end; ++row)
        for (int64_t k = offsets[size_t(row)]; k < offsets[size_t(row) + 1]; ++k) work(row, k);
    });
  }
  std::vector<ListedPair> pairs() const;
};

// Rows of a list in order.
PairRows rows_of(const std::vector<ListedPair>& list, uint64_t firsts);

}  // namespace spherepair
