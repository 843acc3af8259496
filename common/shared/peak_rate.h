// SPDX-License-Identifier: MIT
// What the ceiling kernels compute: nothing that is of use, but something that can be checked.
#ifndef SPHEREPAIR_PEAK_RATE_H
#define SPHEREPAIR_PEAK_RATE_H

#include "common/shared/portable.h"

// Repeated on any float below 2^100 it ends at exactly 1, whether it is rounded once or twice.
FN float towards_one(float x) {
  EXACT float next = multiply_add(x, bits_float(0x3F000000u), bits_float(0x3F000000u));
  return next;
}

// A place among n for each i, spread over all of them, so that neighbours do not add to neighbouring words.
FN uint scattered(uint i, uint n) { return uint((uint64_t(i * 2654435761u) * uint64_t(n)) >> 32); }

#endif
