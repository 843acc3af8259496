// SPDX-License-Identifier: MIT
#include "bench/measure/contest.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr double narrow = 1.25;  // an interval of ratios that is wider, high over low, could hide a difference

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
  if (contest.finding == Finding::undecided)
    return enough_rounds(contest) ? fmt::format("undecided: {} to {}{}", times_text(contest.ratios.low),
                                                times_text(contest.ratios.high), contest.steady ? "" : unsteady_mark)
                                  : fmt::format("undecided: {} only", counted(contest.rounds, "round"));
  return contest.finding == Finding::differ ? times_text(contest.ratio) : "no difference seen";
}

std::string verdict(const Contest& contest) {
  if (contest.finding != Finding::differ) return ratio_text(contest);
  const auto [low, high, coverage] = contest.ratios;
  return fmt::format("{} takes {} [{}, {}] {}'s time", contest.left, times_text(contest.ratio), number_text(low),
                     number_text(high), contest.right);
}

}  // namespace spherepair
