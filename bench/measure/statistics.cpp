// SPDX-License-Identifier: MIT
#include "bench/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace spherepair {
namespace {

std::vector<double> sorted(std::span<const double> sample) {
  if (sample.empty()) throw std::invalid_argument("statistics of an empty sample: take at least one measurement");
  std::vector<double> values(sample.begin(), sample.end());
  std::sort(values.begin(), values.end());
  return values;
}

// P(k heads of n fair coins), by logarithms to avoid overflow.
double coin_probability(double n, double k) {
  return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) - n * std::log(2.0));
}

}  // namespace

double minimum(std::span<const double> sample) { return sorted(sample).front(); }

double median(std::span<const double> sample) { return quantile(sample, 0.5); }

double quantile(std::span<const double> sample, double fraction) {
  const std::vector<double> values = sorted(sample);
  const double at = std::clamp(fraction, 0.0, 1.0) * double(values.size() - 1);
  const size_t below = size_t(at), above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - double(below)) * (values[above] - values[below]);
}

// The k-th smallest and k-th largest value exclude the median if fewer than k values lie on one side of it.
Interval median_interval(std::span<const double> sample, double confidence) {
  const std::vector<double> values = sorted(sample);
  const size_t n = values.size();
  Interval interval{values.front(), values.back(), 1.0};
  double missed = 0;
  for (size_t k = 0; k < (n + 1) / 2; ++k) {
    missed += 2 * coin_probability(double(n), double(k));
    if (k > 0 && 1 - missed < confidence) break;
    interval = {values[k], values[n - 1 - k], std::max(0.0, 1 - missed)};
  }
  return interval;
}

}  // namespace spherepair
