// SPDX-License-Identifier: MIT
// What the samples of one measure() say of the times of two contenders of a contest.
#pragma once

#include "bench/measure/samples.h"

namespace spherepair {

enum class Finding {
  differ,         // the interval of the rounds' ratios is on one side of 1
  no_difference,  // it holds 1 and is narrow
  undecided       // it is wide, or of too few rounds to be one, or of unsteady times
};

// The two take their turns right behind each other in every round, so a load that lasts longer slows down both: it is
// the ratios of the rounds' turns that are looked at, not the medians.
struct Contest {
  Finding finding;
  double ratio;             // of left's time to right's: the median of the rounds' ratios ...
  Interval ratios;          // ... and its interval between order statistics
  size_t rounds;            // that both took part in
  std::string left, right;  // backends
  bool steady = true;       // both times
};
Contest contest(const Samples& left, const Samples& right);
bool enough_rounds(const Contest& contest);       // for an interval of 95 %
std::string spread_text(const Contest& contest);  // 0.54x to 2.10x in 7 rounds
// A cell of a table: 1.07x [1.05, 1.09], "no difference seen", or "undecided [0.54, 2.10]".
std::string ratio_text(const Contest& contest);

}  // namespace spherepair
