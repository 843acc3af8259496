// SPDX-License-Identifier: MIT
// Compares two contenders of a contest by their samples of one measure().
#pragma once

#include "bench/measure/samples.h"

namespace spherepair {

enum class Finding {
  differ,         // the interval of the rounds' ratios excludes 1
  no_difference,  // it contains 1 and is narrow
  undecided       // it is wide, or there are too few rounds, or times are unsteady
};

// In every round both take their turns one right after the other, so a load that lasts longer slows both. Hence the
// ratios of the rounds are compared, not the medians.
struct Contest {
  Finding finding;
  double ratio;             // of left's time to right's: the median of the rounds' ratios ...
  Interval ratios;          // ... and its interval between order statistics
  size_t rounds;            // in which both took part
  std::string left, right;  // backends
  bool steady = true;       // whether both times are steady
};
Contest contest(const Samples& left, const Samples& right);
bool enough_rounds(const Contest& contest);       // enough for an interval of 95 %
std::string spread_text(const Contest& contest);  // 0.54x to 2.10x in 7 rounds
// A cell of a table: 1.07x [1.05, 1.09], "no difference seen", or "undecided [0.54, 2.10]".
std::string ratio_text(const Contest& contest);

}  // namespace spherepair
