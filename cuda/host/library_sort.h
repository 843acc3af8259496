// SPDX-License-Identifier: MIT
// Thrust's radix sort instead of our kernels, to measure what the library is worth. Its temporary memory is kept, so
// that only the first run of a step allocates.
#pragma once

#include <memory>

#include "common/shared/layout.h"

namespace spherepair {

class LibrarySort {
 public:
  LibrarySort();
  ~LibrarySort();

  // Sorts the n spheres by the slots of their cells, on the default stream, without waiting for it. table:
  // uint[cell_slots + 1], where the spheres of each slot begin. sorted, id, sorted_count: as SLOT_SORTED, SLOT_ID and
  // SLOT_SORTED_COUNT, with counts 0.
  void sort(const Params& p, const vec4* position, uint* table, vec4* sorted, uint* id, uint* sorted_count);
  uint64_t take_allocations();  // of device memory, since the last call

 private:
  class Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace spherepair
