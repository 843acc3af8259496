// SPDX-License-Identifier: MIT
// Sorts pair lists into canonical order, in buckets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/backend/growing_list.h"
#include "common/scene/host_buffer.h"
#include "common/scene/pair_set.h"

namespace spherepair {

class PairSort {
 public:
  // Sorts the pairs of several lists. Each pair is first << 32 | second, with spheres below n. Throws std::bad_alloc.
  void sort(std::span<const GrowingList<uint64_t>> lists, uint64_t n, int threads, std::vector<Pair>& sorted);

 private:
  void split(size_t buckets, int threads);

  std::vector<std::span<const uint64_t>> pieces_;
  std::vector<uint64_t> cursor_, begin_;  // [piece][bucket] and [bucket]: places in split_
  Buffer<uint64_t> split_;                // by bucket: first sphere >> shift_
  uint shift_ = 0;
};

}  // namespace spherepair
