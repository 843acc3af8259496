// SPDX-License-Identifier: MIT
#include "bench/measure/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "bench/measure/session.h"
#include "common/scene/counted.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

constexpr double certain = 0.01;  // p of the rank test
constexpr double narrow = 1.25;   // an interval of ratios that is wider, high over low, could hide a difference

std::string times_text(double ratio) { return fmt::format("{:.{}f}x", ratio, ratio < 10 ? 2 : ratio < 100 ? 1 : 0); }

// Fisher-Yates with an integer hash: the same order on every machine.
void shuffle(std::vector<size_t>& order, uint64_t& state) {
  for (size_t left = order.size(); left > 1; --left) {
    state = splitmix64(state);
    std::swap(order[left - 1], order[state % left]);
  }
}

int choose_rounds(const Contender& contender, uint64_t batch, double step, const Sampling& sampling) {
  if (on_hardware(*contender.backend) || step * double(batch) * sampling.rounds <= sampling.round_budget)
    return sampling.rounds;
  return std::min(sampling.rounds, sampling.fewest_rounds);
}

bool all_narrow(std::span<const Samples> all, const Sampling& sampling) {
  return std::ranges::all_of(all, [&](const Samples& one) {
    const Interval interval = one.interval();
    return interval.high - interval.low <= sampling.narrow_enough * one.median_seconds();
  });
}

// Device timers, in a separate run: their queries would disturb the host's times. None has the part of spheres that
// OpenGL draws for another API.
void time_on_device(const Contender& contender, uint64_t batch, Samples& samples) {
  if (!contender.backend->info().device_timers) return;
  const uint64_t steps = std::min<uint64_t>(batch, 20);
  if (contender.restart) contender.restart(*contender.backend);
  contender.backend->time_stages(true);
  for (uint64_t k = 0; k < steps; ++k) contender.step(*contender.backend);
  contender.backend->finish();
  const bool complete = !contender.backend->transfer_taken();
  std::map<std::string, std::vector<double>> by_stage;
  for (const StageTime& time : contender.backend->stage_times()) by_stage[time.stage].push_back(time.seconds);
  contender.backend->time_stages(false);
  if (!complete) return;
  for (const auto& [stage, times] : by_stage) {
    const double launches = double(times.size()) / double(steps);
    const Interval one = median_interval(times);
    samples.stages[stage] = median(times) * launches;
    samples.stage_intervals[stage] = {one.low * launches, one.high * launches, one.coverage};
  }
}

}  // namespace

double Samples::device_seconds() const {
  if (stages.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(stages.begin(), stages.end(), 0.0, [](double sum, const auto& s) { return sum + s.second; });
}

json to_json(const Samples& samples) {
  const auto ms = [](std::vector<double> values) {
    for (double& value : values) value *= 1e3;
    return values;
  };
  const Interval interval = samples.interval();
  json out = {{"label", samples.label},
              {"backend", samples.backend},
              {"batch", samples.batch},
              {"rounds", samples.seconds.size()},
              {"median_ms", samples.median_seconds() * 1e3},
              {"interval_ms", {interval.low * 1e3, interval.high * 1e3}},
              {"coverage", interval.coverage},
              {"min_ms", minimum(samples.seconds) * 1e3},
              {"samples_ms", ms(samples.seconds)},
              {"turns", samples.turn}};
  if (samples.stages.empty()) return out;
  for (const auto& [stage, seconds] : samples.stages) {
    const Interval within = samples.stage_intervals.at(stage);
    out["device_stages_ms"][stage] = seconds * 1e3;
    out["device_stages_interval_ms"][stage] = {within.low * 1e3, within.high * 1e3};
  }
  out["device_ms"] = samples.device_seconds() * 1e3;
  out["host_minus_device_ms"] = (samples.median_seconds() - samples.device_seconds()) * 1e3;
  return out;
}

double time_batch(const Contender& contender, uint64_t batch) {
  Backend& backend = *contender.backend;
  const bool warm_up = batch > 1 && on_hardware(backend);
  const int ahead = warm_up && !contender.restart ? 3 : contender.alternates ? 1 : 0;
  for (int k = 0; k < ahead; ++k) contender.step(backend);  // the second equal step captures a graph
  if (contender.restart) contender.restart(backend);
  backend.finish();
  const auto start = std::chrono::steady_clock::now();
  for (uint64_t k = 0; k < batch; ++k) contender.step(backend);
  backend.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

namespace {

// The least of three, where they are short: one disturbance would make K so small that each step of this contender
// had the price of waking threads or the device, and those of the others had not.
double undisturbed(const Contender& contender, uint64_t batch, double wanted) {
  double least = time_batch(contender, batch);
  for (int more = 0; more < 2 && least < 4 * wanted; ++more) least = std::min(least, time_batch(contender, batch));
  return least;
}

}  // namespace

uint64_t choose_batch(const Contender& contender, const Sampling& sampling) {
  if (contender.batch) return contender.batch;
  const bool hardware = on_hardware(*contender.backend);
  const double wanted = hardware ? sampling.hardware_seconds : sampling.software_seconds;
  uint64_t steps = 1;
  double taken = undisturbed(contender, steps, wanted);
  while (taken < wanted / 4 && steps < (1u << 24)) taken = undisturbed(contender, steps *= 4, wanted);
  const double step = std::max(taken / double(steps), 1e-9);
  const uint64_t batch = std::max<uint64_t>(1, uint64_t(std::ceil(wanted / step)));
  if (!hardware) return batch;
  const auto most = uint64_t(std::ceil(sampling.hardware_peak / step));
  return std::max(batch, std::min(sampling.hardware_batch, most));
}

std::vector<Samples> measure(std::span<const Contender> contenders, const Sampling& sampling, Progress& progress) {
  std::vector<Samples> all;
  std::vector<int> rounds;
  for (const Contender& contender : contenders) {
    progress.say("warming up: " + contender.label);
    Samples samples{contender.label, contender.backend->info().name, choose_batch(contender, sampling), {}, {}, {}, {}};
    const double warm = time_batch(contender, samples.batch) / double(samples.batch);
    rounds.push_back(choose_rounds(contender, samples.batch, warm, sampling));
    all.push_back(std::move(samples));
  }
  uint64_t order_state = sampling.seed, turn = 0;
  for (int round = 0; round < sampling.rounds; ++round) {
    if (sampling.narrow_enough > 0 && round >= sampling.fewest_rounds && all_narrow(all, sampling)) break;
    std::vector<size_t> order;
    for (size_t c = 0; c < all.size(); ++c)
      if (round < rounds[c]) order.push_back(c);
    shuffle(order, order_state);
    for (size_t c : order) {
      progress.say(fmt::format("round {} of {}: {}", round + 1, sampling.rounds, contenders[c].label));
      all[c].seconds.push_back(time_batch(contenders[c], all[c].batch) / double(all[c].batch));
      all[c].turn.push_back(turn++);
    }
  }
  for (size_t c = 0; c < all.size(); ++c) time_on_device(contenders[c], all[c].batch, all[c]);
  return all;
}

// Choosing K and the warm-up take about as long as three samples.
double predict_seconds(std::span<const Samples> samples, double growth, const Sampling& sampling) {
  double sum = 0;
  for (const Samples& one : samples) {
    const double step = one.median_seconds() * growth;
    const double sample = std::max(step, sampling.software_seconds);
    const bool slow = sample * sampling.rounds > sampling.round_budget;
    sum += sample * ((slow ? sampling.fewest_rounds : sampling.rounds) + 3);
  }
  return sum;
}

Contest contest(const Samples& left, const Samples& right) {
  const size_t rounds = std::min(left.seconds.size(), right.seconds.size());
  std::vector<double> ratios(rounds);
  for (size_t k = 0; k < rounds; ++k) ratios[k] = left.seconds[k] / right.seconds[k];
  Contest found{Finding::no_difference,
                left.median_seconds() / right.median_seconds(),
                rank_test(left.seconds, right.seconds),
                median_interval(ratios),
                rounds,
                left.backend,
                right.backend};
  const bool apart = !overlap(left.interval(), right.interval()) || found.p < certain;
  const bool one_side = found.ratio > 1 ? found.ratios.low > 1 : found.ratios.high < 1;
  if (!enough_rounds(found))
    found.finding = Finding::undecided;
  else if (apart && one_side)
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
    return enough_rounds(contest)
               ? fmt::format("undecided: {} to {}", times_text(contest.ratios.low), times_text(contest.ratios.high))
               : fmt::format("undecided: {} too few",
                             contest.rounds == 1 ? "1 round is" : fmt::format("{} rounds are", contest.rounds));
  return contest.finding == Finding::differ ? times_text(contest.ratio) : "no difference seen";
}

std::string verdict(const Contest& contest) {
  if (contest.finding != Finding::differ) return ratio_text(contest);
  return fmt::format("{} takes {} {}'s time", contest.left, ratio_text(contest), contest.right);
}

}  // namespace spherepair
