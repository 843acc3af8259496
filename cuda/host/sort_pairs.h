// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace spherepair {

// Sorts `count` uvec2 in device memory by (x, y), on the default stream.
void sort_pairs(void* pairs, uint64_t count);

}  // namespace spherepair
