// SPDX-License-Identifier: MIT
// Order statistics of timing samples; no normal distribution is assumed.
#pragma once

#include <span>

namespace spherepair {

// Each throws std::invalid_argument for an empty sample.
double median(std::span<const double> sample);
double minimum(std::span<const double> sample);
double quantile(std::span<const double> sample, double fraction);  // linear between order statistics

// An interval between two order statistics that contains the true median with probability `coverage`. In a small sample
// (fewer than 6 values at 95 %) even the whole range has less coverage than `confidence`.
struct Interval {
  double low, high, coverage;
};
constexpr int fewest_for_interval = 6;
Interval median_interval(std::span<const double> sample, double confidence = 0.95);

}  // namespace spherepair
