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

// P(k heads of n fair coins), in logarithms against overflow.
double coin_probability(double n, double k) {
  return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) - n * std::log(2.0));
}

struct Ranks {
  double left_sum = 0;  // of the left sample's ranks; ties have their mean rank
  double ties = 0;      // sum of t^3 - t over groups of equal values
};

Ranks rank_sums(std::span<const double> left, std::span<const double> right) {
  std::vector<std::pair<double, bool>> all;
  for (double value : left) all.emplace_back(value, true);
  for (double value : right) all.emplace_back(value, false);
  std::sort(all.begin(), all.end());
  Ranks ranks;
  for (size_t first = 0, last; first < all.size(); first = last) {
    last = first;
    while (last < all.size() && all[last].first == all[first].first) ++last;
    const double shared = 0.5 * double(first + 1 + last), count = double(last - first);
    for (size_t k = first; k < last; ++k) ranks.left_sum += all[k].second ? shared : 0.0;
    ranks.ties += count * (count * count - 1);
  }
  return ranks;
}

// P(U <= u) by counting: ways[k][s] subsets of k ranks that sum to s, over all subsets of size m.
double exact_tail(size_t m, size_t n, double u) {
  const size_t offset = m * (m + 1) / 2, top = offset + m * n;
  std::vector<std::vector<double>> ways(m + 1, std::vector<double>(top + 1, 0.0));
  ways[0][0] = 1;
  for (size_t rank = 1; rank <= m + n; ++rank)
    for (size_t k = std::min(rank, m); k >= 1; --k)
      for (size_t s = top; s >= rank; --s) ways[k][s] += ways[k - 1][s - rank];
  double all = 0, tail = 0;
  for (size_t s = offset; s <= top; ++s) {
    all += ways[m][s];
    if (double(s - offset) <= u) tail += ways[m][s];
  }
  return tail / all;
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

double rank_test(std::span<const double> left, std::span<const double> right) {
  if (left.empty() || right.empty()) throw std::invalid_argument("rank test: both samples need at least one value");
  const double m = double(left.size()), n = double(right.size());
  const Ranks ranks = rank_sums(left, right);
  const double u = ranks.left_sum - m * (m + 1) / 2, smaller = std::min(u, m * n - u);
  if (ranks.ties == 0 && m <= 40 && n <= 40) return std::min(1.0, 2 * exact_tail(left.size(), right.size(), smaller));
  const double all = m + n, variance = m * n / 12 * (all + 1 - ranks.ties / (all * (all - 1)));
  if (variance <= 0) return 1;
  const double distance = std::max(0.0, std::abs(u - m * n / 2) - 0.5);
  return std::erfc(distance / std::sqrt(2 * variance));
}

}  // namespace spherepair
