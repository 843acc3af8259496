// SPDX-License-Identifier: MIT
#include "bench/measure/samples.h"

#include <fmt/format.h>

#include <limits>
#include <numeric>

namespace spherepair {
namespace {

json scaled(std::vector<double> seconds, double factor) {
  for (double& value : seconds) value *= factor;
  return seconds;
}

json scaled(const Interval& interval, double factor) { return {interval.low * factor, interval.high * factor}; }

json or_null(bool known, json value) { return known ? std::move(value) : json(nullptr); }

// Adds the fixed costs of samples; null if one batch a round cannot tell them.
void add_batches(json& out, const Samples& samples) {
  out["batches"] = samples.plan.steps;
  out["batch_ms"] = json::array();
  std::vector<double> largest;
  for (const std::vector<double>& round : samples.batch_seconds) {
    out["batch_ms"].push_back(scaled(round, 1e3));
    largest.push_back(round.back());
  }
  const bool fitted = !samples.fixed.empty();
  out["fixed_cost_fitted"] = samples.fixed.size();
  out["fixed_cost_us"] = or_null(fitted, fitted ? median(samples.fixed) * 1e6 : 0);
  out["fixed_cost_interval_us"] = or_null(fitted, fitted ? scaled(median_interval(samples.fixed), 1e6) : json());
  out["fixed_cost_share"] = or_null(fitted, fitted ? median(samples.fixed) / median(largest) : 0);
  out["longest_batch_ms"] = samples.longest * 1e3;
  out["bounded_by_longest"] = samples.plan.bounded;
  out["batches_retaken"] = samples.retaken;
  if (samples.prepared == Preparations{}) return;
  out["prepared_in_samples"] = {{"captures", samples.prepared.captures},
                                {"compilations", samples.prepared.compilations},
                                {"allocations", samples.prepared.allocations}};
}

void add_memory(json& out, const Samples& samples) {
  const bool known = samples.working_set != 0;
  out["working_set_bytes"] = or_null(known, samples.working_set);
  out["fits_l2"] = or_null(known && samples.l2, samples.working_set <= samples.l2.value_or(0));
}

// Adds the reasons as text in a list, so that rows of several processes can be merged into one that keeps the mark.
void add_steadiness(json& out, const Samples& samples) {
  out["others_share"] = or_null(samples.others.has_value(), samples.others.value_or(0));
  if (const std::vector<std::string> reasons = samples.unsteady(); !reasons.empty()) out["unsteady"] = reasons;
}

void add_stages(json& out, const Samples& samples) {
  if (samples.timer_floor) out["timer_floor_ms"] = *samples.timer_floor * 1e3;
  if (samples.stages.empty()) return;
  for (const auto& [stage, seconds] : samples.stages) {
    out["device_stages_ms"][stage] = seconds * 1e3;
    out["device_stages_interval_ms"][stage] = scaled(samples.stage_intervals.at(stage), 1e3);
  }
  out["device_stages_at_floor"] = samples.at_floor;
  out["device_ms"] = samples.device_seconds() * 1e3;
  out["host_minus_device_ms"] = (samples.median_seconds() - samples.device_seconds()) * 1e3;
}

}  // namespace

double Samples::device_seconds() const {
  if (stages.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(stages.begin(), stages.end(), 0.0, [](double sum, const auto& s) { return sum + s.second; });
}

void add_turn(Samples& samples, Turn turn, uint64_t position) {
  samples.turn.push_back(position);
  samples.retaken += turn.retaken;
  samples.prepared = samples.prepared + turn.prepared;
  samples.batch_seconds.push_back(std::move(turn.seconds));
}

void fit_rounds(Samples& samples) {
  const std::vector<uint64_t>& steps = samples.plan.steps;
  const auto line = steps.size() > 1 ? fit(steps, samples.batch_seconds) : std::nullopt;
  for (const std::vector<double>& round : samples.batch_seconds) {
    if (!line) {
      samples.seconds.push_back(round.back() / double(steps.back()));
      continue;
    }
    std::vector<double> of_a_step, fixed;
    for (size_t k = 0; k < steps.size(); ++k) {
      of_a_step.push_back((round[k] - line->fixed) / double(steps[k]));
      fixed.push_back(round[k] - line->step * double(steps[k]));
    }
    samples.seconds.push_back(median(of_a_step));
    samples.fixed.push_back(median(fixed));
  }
}

json to_json(const Samples& samples) {
  const Interval interval = samples.interval();
  json out = {{"label", samples.label},
              {"backend", samples.backend},
              {"contest", samples.contest.empty() ? json(nullptr) : json(samples.contest)},
              {"batch", samples.batch()},
              {"rounds", samples.seconds.size()},
              {"median_ms", samples.median_seconds() * 1e3},
              {"interval_ms", scaled(interval, 1e3)},
              {"coverage", interval.coverage},
              {"p95_ms", quantile(samples.seconds, 0.95) * 1e3},
              {"min_ms", minimum(samples.seconds) * 1e3},
              {"samples_ms", scaled(samples.seconds, 1e3)},
              {"turns", samples.turn}};
  add_batches(out, samples);
  add_memory(out, samples);
  add_steadiness(out, samples);
  if (!samples.cores.empty()) out["busy_cores"] = median(samples.cores), out["pinned"] = samples.pinned;
  add_stages(out, samples);
  return out;
}

std::string time_cell(const Samples& samples, double in_second) {
  return time_cell(samples.seconds, in_second, samples.unsteady().empty());
}

std::string time_cell(const std::vector<double>& seconds, double in_second, bool steady) {
  const auto text = [&](double value) { return format_number(value * in_second); };
  const Interval interval = median_interval(seconds);
  std::string cell = text(median(seconds));
  if (interval.coverage >= 0.95) cell += fmt::format(" [{}, {}]", text(interval.low), text(interval.high));
  return cell + (steady ? "" : unsteady_mark);
}

}  // namespace spherepair
