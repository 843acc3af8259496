// SPDX-License-Identifier: MIT
#include "common/device/launch.h"

#include <algorithm>

namespace spherepair {

const char* kernel_name(Kernel kernel) {
#define NAME(name) #name,
  constexpr const char* names[] = {SPHEREPAIR_KERNELS(NAME)};
#undef NAME
  return names[int(kernel)];
}

std::array<uint, 3> folded(uint64_t groups) {
  const uint64_t y = ceil_div(groups, MAX_GROUPS);
  return {uint(y > 1 ? MAX_GROUPS : std::max<uint64_t>(groups, 1)), uint(std::max<uint64_t>(y, 1)), 1};
}

}  // namespace spherepair
