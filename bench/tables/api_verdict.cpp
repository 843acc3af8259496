// SPDX-License-Identifier: MIT
#include "bench/tables/api_verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/scene/counted.h"

namespace spherepair {
namespace {

struct Api {
  const char *name, *title;
};
constexpr Api baseline = {"cuda", "CUDA"};
constexpr Api others[] = {{"opengl", "OpenGL"}, {"vulkan", "Vulkan"}};

std::string why_not(const Session& session, const Api& other) {
  for (const Api& api : {other, baseline}) {
    const Backend* backend = session.find(api.name);
    if (!backend) return fmt::format("{} did not run", api.title);
    if (!on_hardware(*backend))
      return fmt::format("{} ran in software, so its times say nothing about a GPU", api.title);
  }
  return {};
}

// 1.03x to 1.59x CUDA's time in 28 (methods, scale)
std::string of_side(const std::vector<ApiContest>& contests, bool slower) {
  std::vector<double> ratios;
  std::vector<std::string> tables;
  for (const auto& [table, contest] : contests) {
    if (contest.finding != Finding::differ || (contest.ratio > 1) != slower) continue;
    ratios.push_back(contest.ratio);
    if (std::ranges::find(tables, table) == tables.end()) tables.push_back(table);
  }
  if (ratios.empty()) return {};
  const auto [least, most] = std::ranges::minmax(ratios);
  return fmt::format("{:.2f}x to {:.2f}x CUDA's time in {} ({})", least, most, ratios.size(), fmt::join(tables, ", "));
}

std::string verdict_on(const Api& api, const Session& session, const std::vector<ApiContest>& all) {
  std::vector<ApiContest> contests;
  std::ranges::copy_if(all, std::back_inserter(contests), [&](const ApiContest& one) {
    return one.contest.left == api.name && one.contest.right == baseline.name;
  });
  std::string reason = why_not(session, api);
  if (reason.empty() && contests.empty()) reason = "no table timed both";
  if (reason.empty()) return summary_of(api.title, contests);
  return fmt::format("{} or CUDA: this run cannot say which is faster; {}", api.title, reason);
}

}  // namespace

std::string summary_of(const std::string& title, const std::vector<ApiContest>& contests) {
  std::string text = fmt::format("Of {} of time, {} takes ", counted(contests.size(), "comparison"), title);
  const std::string slower = of_side(contests, true), faster = of_side(contests, false);
  text += slower.empty() && faster.empty() ? "another time than CUDA in none" : slower;
  text += (slower.empty() || faster.empty() ? "" : " and ") + faster;
  const auto count = [&](Finding finding) {
    return std::ranges::count_if(contests, [&](const ApiContest& one) { return one.contest.finding == finding; });
  };
  return text + fmt::format("; no difference seen in {}, not decided by this data in {}", count(Finding::no_difference),
                            count(Finding::undecided));
}

std::vector<std::string> api_verdicts(const Session& session, const std::vector<ApiContest>& all) {
  std::vector<std::string> verdicts;
  for (const Api& api : others) verdicts.push_back(verdict_on(api, session, all));
  return verdicts;
}

}  // namespace spherepair
