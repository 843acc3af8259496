// SPDX-License-Identifier: MIT
#include "bench/measure/contest.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr double narrow = 1.25;  // high over low: a wider interval of ratios could hide a difference

std::string number_text(double ratio) { return fmt::format("{:.{}f}", ratio, ratio < 10 ? 2 : ratio < 100 ? 1 : 0); }
std::string times_text(double ratio) { return number_text(ratio) + "x"; }

}  // namespace

Contest contest(const Samples& left, const Samples& right) {
  const size_t rounds = std::min(left.seconds.size(), right.seconds.size());
  std::vector<double> ratios(rounds);
  for (size_t k = 0; k < rounds; ++k) ratios[k] = left.seconds[k] / right.seconds[k];
  Contest found{Finding::no_difference, median(ratios), median_interval(ratios), rounds, left.backend, right.backend};
  found.steady = left.unsteady().empty() && right.unsteady().empty();
  if (!enough_rounds(found) || !found.steady)
    found.finding = Finding::undecided;
  else if (found.ratios.low > 1 || found.ratios.high < 1)
    found.finding = Finding::differ;
  else if (found.ratios.high > narrow * found.ratios.low)
    found.finding = Finding::undecided;
  return found;
}

bool enough_rounds(const Contest& contest) { return contest.ratios.coverage >= 0.95; }

std::string spread_text(const Contest& contest) {
  const auto [low, high, coverage] = contest.ratios;
  return fmt::format("{} to {} in {}", times_text(low), times_text(high), counted(contest.rounds, "round"));
}

std::string ratio_text(const Contest& contest) {
  if (contest.finding == Finding::no_difference) return "no difference seen";
  if (!enough_rounds(contest)) return fmt::format("undecided: {} only", counted(contest.rounds, "round"));
  const std::string finding = contest.finding == Finding::differ ? times_text(contest.ratio) : "undecided";
  return fmt::format("{} [{}, {}]{}", finding, number_text(contest.ratios.low), number_text(contest.ratios.high),
                     contest.steady ? "" : unsteady_mark);
}

}  // namespace spherepair
