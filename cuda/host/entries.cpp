// SPDX-License-Identifier: MIT
#include "cuda/host/entries.h"

namespace spherepair {

Entry entry_of(const Launch& launch) {
#define ENTRY(name, reads, writes) &name##_kernel,
  static constexpr Entry (*entries[])(uint, Variant) = {SPHEREPAIR_KERNELS(ENTRY)};
#undef ENTRY
  return entries[int(launch.kernel)](launch.block, launch.variant);
}

}  // namespace spherepair
