// SPDX-License-Identifier: MIT
// The steps of `spherepair run`.
#pragma once

#include "bench/check/contact_statistics.h"
#include "bench/cli/commands.h"
#include "bench/formats/growing_file.h"
#include "bench/formats/start.h"
#include "bench/options/run_times.h"

namespace spherepair {

struct RunStep {
  uint64_t step, state;
  Collisions totals;
};
json to_json(const RunStep& result);

// Moves to the last step; keeps the results of the last step, or of every step with --per-step. Writes checkpoints and
// statistics on the way. If a step fails, the rows before it are already in the file.
class Run {
 public:
  Run(Backend& backend, const RunOptions& options, const Start& start, const CollideOptions& collide, RunTimes& times)
      : backend_(backend),
        options_(options),
        start_(start),
        collide_(collide),
        times_(times),
        table_(options.statistics_file),
        step_(start.step),
        end_(start.step + options.steps) {}

  std::vector<RunStep> simulate();
  const std::vector<ContactStatistics>& statistics() const { return statistics_; }

 private:
  template <typename Work>
  std::vector<RunStep> time_last(Work work);
  uint64_t next_stop() const;
  void move_to(uint64_t stop);
  void stand();
  uint64_t statistics_every() const { return options_.statistics_file.empty() ? 0 : options_.statistics_every; }

  Backend& backend_;
  const RunOptions& options_;
  const Start& start_;
  CollideOptions collide_;
  RunTimes& times_;
  GrowingFile table_;  // of the statistics
  uint64_t step_, end_;
  Progress progress_;
  std::vector<RunStep> results_;
  std::vector<ContactStatistics> statistics_;
};

}  // namespace spherepair
