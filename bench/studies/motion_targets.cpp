// SPDX-License-Identifier: MIT
#include "bench/studies/motion_targets.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/scene/counted.h"

namespace spherepair {
namespace {

// The time of this method; null if it is unsteady.
const TimeEntry* time_of(const std::vector<TimeEntry>& times, const std::string& backend, MotionMethod method, int k) {
  const auto found = std::ranges::find_if(times, [&](const TimeEntry& entry) {
    return entry.backend == backend && entry.motion == MotionOptions{method, Precision::float32} && entry.k == k &&
           entry.work == "move" && entry.samples.unsteady().empty();
  });
  return found == times.end() ? nullptr : &*found;
}

const ErrorEntry* error_of(const std::vector<ErrorEntry>& errors, MotionMethod method, int k) {
  const auto found = std::ranges::find_if(errors, [&](const ErrorEntry& entry) {
    return entry.motion == MotionOptions{method, Precision::float32} && entry.k == k;
  });
  return found == errors.end() ? nullptr : &*found;
}

// Uses the first time step: the memory traffic of `paper` does not depend on it.
void add_bandwidth(std::vector<Target>& targets, const std::vector<TimeEntry>& times, const CopyEntry& copy) {
  if (times.empty()) return;
  const TimeEntry* paper = time_of(times, copy.backend, MotionMethod::paper, times.front().k);
  if (!paper) return;
  const double rate = double(*bytes_per_sphere_step(*paper)) / paper->per_sphere();
  targets.push_back(
      {fmt::format("{}: bandwidth of paper over that of copying, {}", copy.backend, counted(copy.n, "sphere")),
       rate / copy.bytes_per_second(), 0.85, true});
}

void add_anchored(std::vector<Target>& targets, const std::vector<ErrorEntry>& errors,
                  const std::vector<TimeEntry>& times, const std::string& backend) {
  for (const TimeEntry& anchored : times) {
    if (&anchored != time_of(times, backend, MotionMethod::anchored, anchored.k)) continue;
    const TimeEntry* paper = time_of(times, backend, MotionMethod::paper, anchored.k);
    if (!paper || anchored.bouncing < 0.005 || anchored.bouncing > 0.02) continue;
    const std::string where =
        fmt::format("{}: dt = 2^-{} s, {:.1f} % bounce", backend, anchored.k, 100 * anchored.bouncing);
    targets.push_back(
        {where + ", time of paper over that of anchored", paper->per_sphere() / anchored.per_sphere(), 2, true});
    const ErrorEntry* coarse = error_of(errors, MotionMethod::paper, anchored.k);
    const ErrorEntry* fine = error_of(errors, MotionMethod::anchored, anchored.k);
    if (coarse && fine)
      targets.push_back({where + ", error of anchored over that of paper", fine->rms / coarse->rms, 1, false});
  }
}

}  // namespace

std::vector<Target> motion_targets(const Session& session, const std::vector<ErrorEntry>& errors,
                                   const std::vector<TimeEntry>& times, const std::vector<CopyEntry>& copies) {
  std::vector<Target> targets;
  for (const CopyEntry& copy : copies) {
    if (!on_hardware(*session.find(copy.backend))) continue;
    add_bandwidth(targets, times, copy);
    add_anchored(targets, errors, times, copy.backend);
  }
  if (times.empty()) return targets;
  for (const auto& [device, baseline] : session.contests()) {
    if (!on_hardware(*device)) continue;
    const std::string &name = device->info().name, &other = baseline->info().name;
    const TimeEntry* left = time_of(times, name, MotionMethod::paper, times.front().k);
    const TimeEntry* right = time_of(times, other, MotionMethod::paper, times.front().k);
    if (!left || !right) continue;
    targets.push_back({fmt::format("{}: time of paper over that of {}", name, other),
                       contest(left->samples, right->samples).ratio, 1.05, false});
  }
  return targets;
}

Table target_table(const std::vector<Target>& targets) {
  Table table{"Targets", {{"", "what", "", true}, {"", "value", ""}, {"", "bound", ""}, {"", "", "", true}}, {}, {}};
  for (const Target& target : targets)
    table.rows.push_back({target.what, format_number(target.value),
                          fmt::format("{} {}", target.at_least ? ">=" : "<=", target.bound),
                          target.met() ? "met" : "MISSED"});
  return table;
}

json to_json(const Target& target) {
  return {{"what", target.what},
          {"value", target.value},
          {"bound", fmt::format("{} {}", target.at_least ? ">=" : "<=", target.bound)},
          {"met", target.met()}};
}

}  // namespace spherepair
