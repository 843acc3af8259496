// SPDX-License-Identifier: MIT
// Reciprocal and square root with the same bits everywhere, for images: GLSL's own differ by driver. Newton's iteration
// starts from a guess made from the argument's bits and uses only correctly rounded products and differences. Results
// are within 2^-21 of the right ones. Arguments are between 2^-120 and 2^120.
#ifndef SPHEREPAIR_ROUND_H
#define SPHEREPAIR_ROUND_H

#include "common/shared/portable.h"

FN float same_reciprocal(float x) {
  EXACT float y = bits_float(0x7EF311C7u - float_bits(x));
  for (int k = 0; k < 3; ++k) {
    EXACT float wrong = x * y;
    EXACT float better = y * (2.0f - wrong);
    y = better;
  }
  return y;
}

// Returns the square root, or 0 below 2^-100.
FN float same_root(float x) {
  if (!(x >= bits_float(0x0D800000u))) return 0.0f;
  EXACT float y = bits_float(0x5F375A86u - (float_bits(x) >> 1));
  EXACT float half_x = x * 0.5f;
  for (int k = 0; k < 3; ++k) {
    EXACT float wrong = (half_x * y) * y;
    EXACT float better = y * (1.5f - wrong);
    y = better;
  }
  EXACT float root = x * y;
  return root;
}

#endif
