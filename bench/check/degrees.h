// SPDX-License-Identifier: MIT
// The numbers of contacts per sphere.
#pragma once

#include <span>

#include "bench/io/report.h"
#include "common/shared/layout.h"

namespace spherepair {

// Spheres with `from` to `to` contacts: one bin per degree up to 15, then one per power of two.
struct DegreeBin {
  uint from, to;
  uint64_t spheres;
};

struct Degrees {
  uint64_t spheres = 0;
  uint least = 0, most = 0;
  double median = 0, mean = 0;
  std::vector<DegreeBin> bins;  // contiguous, from `least` to `most`
};

Degrees degrees_of(std::span<const uint> counts);
Table degree_table(const Degrees& degrees);
json to_json(const Degrees& degrees);

}  // namespace spherepair
