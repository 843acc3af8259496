// SPDX-License-Identifier: MIT
// A sum of float64 numbers without rounding: grow-expansion of J. R. Shewchuk, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates", Discrete & Computational Geometry 18 (1997), section 2.4.
#pragma once

#include <cmath>
#include <cstddef>

#include "common/shared/portable.h"

namespace spherepair {

// Of `Terms` numbers at most. Exact as long as nothing over- or underflows. Kept as numbers none of whose bits overlap,
// ascending.
template <size_t Terms>
class ExactSum {
 public:
  FN void add(double term) {
    size_t kept = 0;
    for (size_t k = 0; k < count_; ++k) {
      const double other = parts_[k], sum = term + other, from_other = sum - term;
      const double rest = (term - (sum - from_other)) + (other - from_other);
      if (rest != 0) parts_[kept++] = rest;
      term = sum;
    }
    if (term != 0) parts_[kept++] = term;
    count_ = kept;
  }
  // Counts as two terms.
  FN void add_product(double a, double b) {
    const double product = a * b, rest = fma(a, b, -product);
    if (rest != 0) add(rest);
    if (product != 0) add(product);
  }
  // At most one unit in the last place from the sum, with its sign.
  FN double rounded() const {
    double sum = 0;
    for (size_t k = 0; k < count_; ++k) sum += parts_[k];
    return sum;
  }
  const double* begin() const { return parts_; }
  const double* end() const { return parts_ + count_; }

 private:
  double parts_[Terms];
  size_t count_ = 0;
};

}  // namespace spherepair
