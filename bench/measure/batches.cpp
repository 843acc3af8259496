// SPDX-License-Identifier: MIT
#include "bench/measure/batches.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "bench/measure/session.h"

namespace spherepair {
namespace {

constexpr int attempts = 3;
constexpr uint64_t most_steps = 1u << 24;

// The times by which a contender chooses K.
struct Estimate {
  double step, fixed;  // seconds
};

// The least of three times if they are short. One disturbance would make K so small that this contender's steps, but
// not the others', included the cost of waking threads or the device.
double undisturbed(const Contender& contender, uint64_t steps, double wanted, const Clocks& clocks) {
  const auto taken = [&] { return time_batch(contender, steps, steps_ahead(contender, most_steps), clocks).seconds; };
  double least = taken();
  for (int more = 0; more < 2 && least < 4 * wanted; ++more) least = std::min(least, taken());
  return least;
}

double least_duration(const Contender& contender, const Sampling& sampling) {
  return on_hardware(*contender.backend) ? sampling.hardware_seconds : sampling.software_seconds;
}

// Estimates from the time of one step and of a longer batch. A step longer than a quarter of the longest batch is timed
// alone.
Estimate estimate(const Contender& contender, const Sampling& sampling) {
  const double wanted = least_duration(contender, sampling);
  time_batch(contender, 1, steps_ahead(contender, most_steps), sampling.clocks);  // compiles, allocates, wakes up
  const double one = undisturbed(contender, 1, wanted, sampling.clocks);
  if (4 * one > sampling.longest) return {one, 0};
  uint64_t steps = 1;
  double taken = one;
  while (steps == 1 || (taken < wanted / 4 && steps < most_steps))
    taken = undisturbed(contender, steps *= 4, wanted, sampling.clocks);
  const double slope = (taken - one) / double(steps - 1);
  const double step = std::max(slope > 0 ? slope : taken / double(steps), 1e-9);
  return {step, std::max(0.0, one - step)};
}

std::string prepared_text(const Preparations& prepared) {
  return fmt::format("{} graphs were captured, {} programs compiled or kernels loaded and {} buffers allocated",
                     prepared.captures, prepared.compilations, prepared.allocations);
}

void enqueue(const Contender& contender, uint64_t steps) {
  if (contender.steps) return contender.steps(*contender.backend, steps);
  for (uint64_t k = 0; k < steps; ++k) contender.step(*contender.backend);
}

}  // namespace

int steps_ahead(const Contender& contender, uint64_t largest) {
  if (contender.restart) return 3;
  if (on_hardware(*contender.backend)) return largest > 1 ? 3 : 1;  // the second equal step captures a graph
  return contender.alternates ? 1 : 0;
}

Batch time_batch(const Contender& contender, uint64_t steps, int ahead, const Clocks& clocks) {
  Backend& backend = *contender.backend;
  if (contender.restart) contender.restart(backend);
  for (int k = 0; k < ahead; ++k) contender.step(backend);
  backend.finish();
  const Preparations before = backend.preparations();
  const double cores = clocks.cores(), start = clocks.wall();
  enqueue(contender, steps);
  const double enqueuing = clocks.wall() - start;
  backend.finish();
  const double seconds = clocks.wall() - start;
  return {seconds, (clocks.cores() - cores) / seconds, enqueuing, backend.preparations() - before};
}

BatchPlan plan_batches(std::span<const Contender* const> contenders, const Sampling& sampling) {
  double wanted = double(contenders.front()->batch), most = double(most_steps);
  for (const Contender* contender : contenders) {
    if (contender->batch) continue;
    const auto [step, fixed] = estimate(*contender, sampling);
    const double of_batch = (1 - sampling.fixed_share) * fixed / sampling.fixed_share;  // seconds of steps alone
    wanted =
        std::max({1.0, wanted, std::ceil(least_duration(*contender, sampling) / step), std::ceil(of_batch / step)});
    most = std::min(most, std::max(1.0, std::floor((sampling.longest - fixed) / step)));
  }
  const uint64_t largest = uint64_t(std::min(wanted, most));
  BatchPlan plan{{largest}, wanted > most, sampling.ahead};
  if (largest >= 4) plan.steps = {largest / 4, largest / 2, largest};
  return plan;
}

Turn take_turn(const Contender& contender, const BatchPlan& plan, const Clocks& clocks, uint64_t& order) {
  Turn turn{std::vector<double>(plan.steps.size()), 0, 0, {}};
  std::vector<size_t> batches(plan.steps.size());
  std::iota(batches.begin(), batches.end(), 0);
  shuffle(batches, order);
  const int ahead = steps_ahead(contender, plan.steps.back());
  const uint64_t untimed = on_hardware(*contender.backend) ? uint64_t(plan.ahead * double(plan.steps.back())) : 0;
  for (const size_t k : batches) {
    Batch batch;
    for (int attempt = 1;; ++attempt) {
      if (untimed) time_batch(contender, untimed, ahead, clocks);
      batch = time_batch(contender, plan.steps[k], ahead, clocks);
      if (contender.prepares || batch.prepared == Preparations{}) break;
      if (attempt == attempts)
        throw BackendError(
            fmt::format("{}: {} inside {} samples of {} steps in a row, so its time would not be that of its steps; "
                        "prepare them before, or declare that this is part of the step",
                        contender.label, prepared_text(batch.prepared), attempts, plan.steps[k]));
      ++turn.retaken;
    }
    turn.seconds[k] = batch.seconds;
    turn.prepared = turn.prepared + batch.prepared;
    if (k + 1 == plan.steps.size()) turn.cores = batch.cores;
  }
  return turn;
}

// A line with the least sum goes through two of the batches. If several lines have it, so do the lines between them.
std::optional<Fit> fit(std::span<const uint64_t> steps, std::span<const std::vector<double>> rounds) {
  std::vector<std::array<double, 2>> batches;
  for (const std::vector<double>& round : rounds)
    for (size_t k = 0; k < steps.size(); ++k) batches.push_back({double(steps[k]), round[k]});
  struct Line {
    double sum;
    Fit fit;
  };
  std::vector<Line> lines;
  for (size_t i = 0; i < batches.size(); ++i)
    for (size_t j = i + 1; j < batches.size(); ++j) {
      if (batches[i][0] == batches[j][0]) continue;
      const double step = (batches[j][1] - batches[i][1]) / (batches[j][0] - batches[i][0]);
      const double fixed = batches[i][1] - step * batches[i][0];
      double sum = 0;
      for (const auto& [count, seconds] : batches) sum += std::abs(seconds - fixed - step * count);
      lines.push_back({sum, {step, fixed}});
    }
  const double least = std::ranges::min(lines, {}, &Line::sum).sum;
  std::erase_if(lines, [&](const Line& line) { return line.sum > least * (1 + 1e-9); });
  Fit middle{};
  for (const Line& line : lines) middle.step += line.fit.step, middle.fixed += line.fit.fixed;
  middle = {middle.step / double(lines.size()), middle.fixed / double(lines.size())};
  return middle.step > 0 ? std::optional(middle) : std::nullopt;
}

}  // namespace spherepair
