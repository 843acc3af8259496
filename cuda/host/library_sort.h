// SPDX-License-Identifier: MIT
// Thrust's radix sort in place of our kernels, to know what the library is worth. Its temporary memory is
// kept, so that a step allocates nothing once it has run before.
#pragma once

#include <memory>

#include "common/shared/layout.h"

namespace spherepair {

class LibrarySort {
 public:
  LibrarySort();
  ~LibrarySort();

  // The n spheres by the slots of their cells, on the default stream, which it does not wait for. table:
  // uint[cell_slots + 1], where the spheres of each slot begin; sorted, id, sorted_count: as SLOT_SORTED, SLOT_ID and
  // SLOT_SORTED_COUNT, the counts 0.
  void sort(const Params& p, const vec4* position, uint* table, vec4* sorted, uint* id, uint* sorted_count);
  uint64_t take_allocations();  // of device memory, since the last call

 private:
  class Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace spherepair
