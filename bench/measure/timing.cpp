// SPDX-License-Identifier: MIT
#include "bench/measure/timing.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/measure/pinned_team.h"

namespace spherepair {
namespace {

bool on_host(const Contender& contender) { return contender.backend->info().on_host; }

// Indices of the contenders by the key that they share, in order of first appearance.
template <typename Key>
std::vector<std::vector<size_t>> grouped(std::span<const Contender> contenders, Key key_of) {
  std::vector<std::string> keys;
  std::vector<std::vector<size_t>> groups;
  for (size_t c = 0; c < contenders.size(); ++c) {
    const std::string key = key_of(c);
    const auto found = size_t(std::ranges::find(keys, key) - keys.begin());
    if (found == keys.size()) keys.push_back(key), groups.emplace_back();
    groups[found].push_back(c);
  }
  return groups;
}

class Measurement {
 public:
  Measurement(Session& session, std::span<const Contender> contenders, const Sampling& sampling, Progress& progress)
      : session_(session), contenders_(contenders), sampling_(sampling), progress_(progress), order_(sampling.seed) {}

  std::vector<Samples> run() {
    for (const Contender& contender : contenders_) {
      Samples samples{contender.label, contender.backend->info().name, contender.contest};
      samples.longest = sampling_.longest;
      samples.working_set = contender.working_set;
      samples.l2 = session_.l2_bytes(*contender.backend);
      all_.push_back(std::move(samples));
    }
    const OtherPrograms others(sampling_.clocks);
    choose_steps();
    auto contests = grouped(contenders_, [&](size_t c) { return contest_of(c); });
    uint64_t position = 0;
    for (int round = 1; round <= sampling_.rounds; ++round) {
      shuffle(contests, order_);
      for (std::vector<size_t>& contest : contests) {
        shuffle(contest, order_);
        for (const size_t c : contest) {
          progress_.say(fmt::format("round {} of {}: {}", round, sampling_.rounds, contenders_[c].label));
          turn(c, position++);
        }
      }
      std::ranges::sort(contests);
    }
    const std::optional<double> busy = others.share();
    for (Samples& samples : all_) {
      fit_rounds(samples);
      samples.others = busy;
      session_.timings.add(!samples.unsteady().empty());
    }
    for (size_t c = 0; c < all_.size(); ++c) time_on_device(c);
    return std::move(all_);
  }

 private:
  std::string contest_of(size_t c) const {
    return contenders_[c].contest.empty() ? fmt::format("alone {}", c) : "contest " + contenders_[c].contest;
  }

  void choose_steps() {
    const auto side_of = [&](size_t c) { return contest_of(c) + (on_host(contenders_[c]) ? " host" : " device"); };
    for (const auto& group : grouped(contenders_, side_of)) {
      std::vector<const Contender*> members;
      for (const size_t c : group) members.push_back(&contenders_[c]);
      progress_.say("warming up: " + members.front()->label);
      std::optional<PinnedTeam> team;
      if (on_host(*members.front())) team.emplace(threads_of(members.front()->backend->info()));
      const BatchPlan plan = plan_batches(members, sampling_);
      for (const size_t c : group) all_[c].plan = plan;
    }
  }

  void turn(size_t c, uint64_t position) {
    std::optional<PinnedTeam> team;
    if (on_host(contenders_[c])) team.emplace(threads_of(contenders_[c].backend->info()));
    Turn taken = take_turn(contenders_[c], all_[c].plan, sampling_.clocks, order_);
    if (team) all_[c].cores.push_back(taken.cores), all_[c].pinned = team->pinned();
    add_turn(all_[c], std::move(taken), position);
  }

  // Times the stages in a separate run: the queries would disturb the host's times. No timer covers drawing through
  // OpenGL for another API.
  void time_on_device(size_t c) {
    Backend& backend = *contenders_[c].backend;
    Samples& samples = all_[c];
    if (!backend.info().device_timers) return;
    samples.timer_floor = session_.timer_floor(backend);
    const uint64_t steps = std::min<uint64_t>(samples.batch(), 20);
    if (contenders_[c].restart) contenders_[c].restart(backend);
    backend.time_stages(true);
    for (uint64_t k = 0; k < steps; ++k) contenders_[c].step(backend);
    backend.finish();
    const Drawing* drawing = backend.drawing();
    const bool complete = !drawing || !drawing->transfer_taken();
    std::map<std::string, std::vector<double>> by_stage;
    for (const StageTime& time : backend.stage_times()) by_stage[time.stage].push_back(time.seconds);
    backend.time_stages(false);
    if (!complete) return;
    for (const auto& [stage, times] : by_stage) {
      const double launches = double(times.size()) / double(steps);
      const Interval one = median_interval(times);
      samples.stages[stage] = median(times) * launches;
      samples.stage_intervals[stage] = {one.low * launches, one.high * launches, one.coverage};
      if (median(times) <= *samples.timer_floor) samples.at_floor.push_back(stage);
    }
  }

  Session& session_;
  std::span<const Contender> contenders_;
  const Sampling& sampling_;
  Progress& progress_;
  uint64_t order_;  // of the random orders
  std::vector<Samples> all_;
};

}  // namespace

std::vector<Samples> measure(Session& session, std::span<const Contender> contenders, const Sampling& sampling,
                             Progress& progress) {
  return Measurement(session, contenders, sampling, progress).run();
}

// Choosing K and the warm-up take about as long as three rounds.
double predict_seconds(std::span<const Samples> samples, double growth, const Sampling& sampling) {
  double sum = 0;
  for (const Samples& one : samples) {
    const double step = one.median_seconds() * growth, batch = std::max(step, sampling.software_seconds);
    const bool several = batch >= 4 * step;  // K/4, K/2 and K steps
    sum += (several ? 1.75 : 1) * batch * (sampling.rounds + 3);
  }
  return sum;
}

}  // namespace spherepair
