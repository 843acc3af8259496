// SPDX-License-Identifier: MIT
// How many contacts the spheres have.
#pragma once

#include <span>

#include "bench/io/report.h"
#include "common/shared/layout.h"

namespace spherepair {

// Spheres with `from` to `to` contacts: each degree by itself up to 15, then grouped from a power of two to the next.
struct DegreeBin {
  uint from, to;
  uint64_t spheres;
};

struct Degrees {
  uint64_t spheres = 0;
  uint least = 0, most = 0;
  double median = 0, mean = 0;
  std::vector<DegreeBin> bins;  // from that of `least` to that of `most`, without a gap
};

Degrees degrees_of(std::span<const uint> counts);
Table degree_table(const Degrees& degrees);
json to_json(const Degrees& degrees);

}  // namespace spherepair
