// SPDX-License-Identifier: MIT
// The steps of `spherepair run`.
#pragma once

#include "bench/check/contact_statistics.h"
#include "bench/formats/growing_file.h"
#include "bench/run/run_options.h"
#include "bench/run/run_times.h"

namespace spherepair {

struct RunStep {
  uint64_t step, state;
  Collisions totals;
};
json to_json(const RunStep& result);

// How a run ended.
struct RunSummary {
  uint64_t step = 0;
  double seconds = 0;                              // step * dt
  double greatest_speed = 0;                       // m/s
  std::optional<bool> at_rest = {};                // the last step changed no bit; none if spheres cannot come to rest
  std::optional<ContactStatistics> contacts = {};  // if spheres push each other and the search finds every pair
};
std::string text_of(const RunSummary& summary);
json to_json(const RunSummary& summary);

// Moves to the last step, or until all spheres are at rest; keeps the results of the last step, or of every step with
// --per-step. Writes checkpoints, statistics and the trajectory on the way. If a step fails, files written before it
// stay.
class Run {
 public:
  Run(Backend& backend, const RunOptions& options, const Start& start, const CollideOptions& collide, RunTimes& times)
      : backend_(backend),
        options_(options),
        start_(start),
        collide_(collide),
        times_(times),
        table_(options.statistics_file),
        trajectory_(options.trajectory_file),
        step_(start.step),
        end_(end_of(options, start)),
        most_(end_) {}

  std::vector<RunStep> simulate();
  const std::vector<ContactStatistics>& statistics() const { return statistics_; }
  const RunSummary& summary() const { return summary_; }

 private:
  template <typename Work>
  std::vector<RunStep> time_last(Work work);
  uint64_t next_stop() const;
  void move_to(uint64_t stop);
  void stand();
  void look_for_rest(uint64_t state);
  void summarize(const Motion::State& state);
  bool is_due(uint64_t every) const { return every && (step_ == end_ || step_ == start_.step || step_ % every == 0); }
  bool finds_contacts() const;
  uint64_t statistics_every() const { return options_.statistics_file.empty() ? 0 : options_.statistics_every; }
  uint64_t trajectory_every() const { return options_.trajectory_file.empty() ? 0 : options_.trajectory_every; }

  Backend& backend_;
  const RunOptions& options_;
  const Start& start_;
  CollideOptions collide_;
  RunTimes& times_;
  GrowingFile table_;  // of the statistics
  GrowingFile trajectory_;
  uint64_t step_, end_;
  const uint64_t most_;          // end_, unless all come to rest earlier
  std::optional<RunStep> seen_;  // the last state that was compared for rest
  Progress progress_;
  std::vector<RunStep> results_;
  std::vector<ContactStatistics> statistics_;
  RunSummary summary_;
};

}  // namespace spherepair
