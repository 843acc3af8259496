// SPDX-License-Identifier: MIT
#include "bench/run/run_times.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/scene/counted.h"

namespace spherepair {

// NOLINTNEXTLINE(performance-unnecessary-value-param): the caller's list is made for this
void RunTimes::set_stages(const Backend& backend, std::vector<StageTime> stages) {
  by_device_ = backend.info().device_timers;
  stages_.clear();
  for (const StageTime& one : stages) {
    const auto found = std::ranges::find(stages_, one.stage, &StageTime::stage);
    if (found == stages_.end())
      stages_.push_back(one);
    else
      found->seconds += one.seconds;
  }
}

double RunTimes::total() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::string RunTimes::text() const {
  std::string text = fmt::format("{:.3f} s in all: spheres {:.3f} s, opening and upload {:.3f} s", total(),
                                 seconds_[spheres], seconds_[opening]);
  std::string each;
  const auto add = [&](Part part, const char* one, const char* many) {
    if (counts_[part] == 0) return;
    text += fmt::format(", {} {:.3f} s", counted(counts_[part], one, many), seconds_[part]);
    each +=
        fmt::format("{}a {} {} ms", each.empty() ? "" : ", ", one, format_ms(seconds_[part] / double(counts_[part])));
  };
  add(moves, "move", "moves");
  add(searches, "search", "searches");
  add(states, "reading of the state", "readings of the state");
  text += "\n" + each + "\n";
  if (stages_.empty()) return text;
  text += fmt::format("the last step on {}:", by_device_ ? "the device's timer" : "the host's clock");
  for (const StageTime& one : stages_) text += fmt::format(" {} {},", one.stage, format_ms(one.seconds));
  text.back() = ' ';
  return text + "ms\n";
}

json RunTimes::to_json() const {
  json stages = json::object();
  for (const StageTime& one : stages_) stages[one.stage] = 1e3 * one.seconds;
  return {{"total_s", total()},
          {"spheres_s", seconds_[spheres]},
          {"opening_s", seconds_[opening]},
          {"moves", counts_[moves]},
          {"moves_s", seconds_[moves]},
          {"searches", counts_[searches]},
          {"searches_s", seconds_[searches]},
          {"states_s", seconds_[states]},
          {"last_step_ms", stages},
          {"last_step_timer", by_device_ ? "device" : "host"}};
}

}  // namespace spherepair
