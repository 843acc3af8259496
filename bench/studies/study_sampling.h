// SPDX-License-Identifier: MIT
// The studies' sampling.
#pragma once

#include "bench/measure/batches.h"

namespace spherepair {

// On a GPU the longest batch lasts so long that OpenGL's fixed cost, 50 to 80 us, is under 0.5 % of it, with a short
// batch ahead of each (docs/NOTES/measuring.md).
inline Sampling study_sampling(int rounds = Sampling{}.rounds) {
  return {.rounds = rounds, .hardware_seconds = 0.02, .ahead = 0.25};
}

}  // namespace spherepair
