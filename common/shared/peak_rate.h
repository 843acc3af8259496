// SPDX-License-Identifier: MIT
// What the peak-rate kernels compute: of no use by itself, but its result can be checked.
#ifndef SPHEREPAIR_PEAK_RATE_H
#define SPHEREPAIR_PEAK_RATE_H

#include "common/shared/portable.h"

// Iterated from any float below 2^100 it converges to exactly 1, whether it is rounded once or twice.
FN float towards_one(float x) {
  EXACT float next = multiply_add(x, bits_float(0x3F000000u), bits_float(0x3F000000u));
  return next;
}

// An index below n for each i, spread over all of them, so that neighbouring threads do not add to neighbouring words.
FN uint scattered(uint i, uint n) { return uint((uint64_t(i * 2654435761u) * uint64_t(n)) >> 32); }

#endif
