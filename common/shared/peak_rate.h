// SPDX-License-Identifier: MIT
// The work of the peak-rate kernels. It has no use, but its result can be checked.
#ifndef SPHEREPAIR_PEAK_RATE_H
#define SPHEREPAIR_PEAK_RATE_H

#include "common/shared/portable.h"

// Returns a step that, iterated from any float below 2^100, converges to exactly 1, rounded once or twice.
FN float towards_one(float x) {
  EXACT float next = multiply_add(x, bits_float(0x3F000000u), bits_float(0x3F000000u));
  return next;
}

// Returns an index below n for each i. Indices are spread over all n, so that neighbouring threads add to distant
// words.
FN uint scattered(uint i, uint n) { return uint((uint64_t(i * 2654435761u) * uint64_t(n)) >> 32); }

#endif
