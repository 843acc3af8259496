// SPDX-License-Identifier: MIT
#include "bench/measure/steadiness.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "bench/measure/session.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

bool is_busy(std::optional<double> others) { return others.value_or(0) > busy_share; }

std::string of_cores(double share) { return fmt::format("{:.0f} % of this machine's cores busy", 100 * share); }

std::optional<double> share_before(const Clocks& clocks) {
  const OtherPrograms others(clocks);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  return others.share();
}

}  // namespace

std::vector<std::string> unsteady(const Interval& interval, std::optional<double> others) {
  std::vector<std::string> reasons;
  if (is_busy(others)) reasons.push_back("other programs kept " + of_cores(*others));
  if (interval.high > widest_interval * interval.low)
    reasons.push_back(fmt::format("its interval is wider than {}x", widest_interval));
  return reasons;
}

StudyLoad::StudyLoad(const Clocks& clocks) : clocks_(clocks), start_(share_before(clocks_)), since_(clocks_) {}

std::vector<std::string> StudyLoad::own(const Session& session) const {
  std::vector<std::string> found;
  const auto during = since_.share();
  if (is_busy(start_) || is_busy(during))
    found.push_back(
        fmt::format("WARNING: other programs kept {} when this study began{}. Stop them and record it again.",
                    of_cores(start_.value_or(0)), during ? fmt::format(", {:.0f} % since", 100 * *during) : ""));
  if (const TimingCounts& timings = session.timings; timings.unsteady)
    found.push_back(fmt::format(
        "WARNING: a busy machine, or an interval wider than {}x, marks {} of {} with !. Such a time decides nothing.",
        widest_interval, timings.unsteady, counted(timings.all, "timing")));
  return found;
}

std::vector<std::string> StudyLoad::warnings(const Session& session) const {
  std::vector<std::string> all = session.warnings();
  for (std::string& one : own(session)) all.push_back(std::move(one));
  return all;
}

std::string StudyLoad::text(const Session& session) const {
  std::string lines;
  for (const std::string& one : own(session)) lines += wrapped(one, "* ", "  ") + "\n";
  return lines;
}

}  // namespace spherepair
