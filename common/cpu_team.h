// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace spherepair {

// Threads for work of so many shares: one or all. A team of some in between would be dear: OpenMP's runtime (GCC's)
// ends the threads that it leaves out, and starts them anew for the next larger team.
inline int team_of(uint64_t shares, int threads) { return shares < 2 ? 1 : threads; }

}  // namespace spherepair
