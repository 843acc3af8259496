// SPDX-License-Identifier: MIT
// The samples of one contender: a time per step for each round, and the data to judge them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/io/report.h"
#include "bench/measure/batches.h"
#include "bench/measure/statistics.h"
#include "bench/measure/steadiness.h"

namespace spherepair {

struct Samples {
  std::string label, backend, contest;
  std::vector<double> seconds = {};                     // per step, one value a round
  std::vector<uint64_t> turn = {};                      // position of each value in the sequence of all turns
  BatchPlan plan = {};                                  // of every turn
  std::vector<std::vector<double>> batch_seconds = {};  // by round, in the order of the plan's steps
  std::vector<double> fixed = {};     // seconds that a batch takes besides its steps, by round; empty without a fit
  double longest = 0;                 // Sampling::longest
  uint64_t retaken = 0;               // batches, since something was prepared in them
  Preparations prepared = {};         // in the samples, if preparing is part of the steps
  std::vector<double> cores = {};     // busy cores of the process, by round; empty for devices
  bool pinned = false;                // each thread of the host had a core of its own
  std::optional<double> others = {};  // share of the machine's cores that other programs kept busy
  uint64_t working_set = 0;           // bytes; 0: not known
  std::optional<uint64_t> l2 = {};    // bytes of the device's cache; none: not known

  std::map<std::string, double> stages = {};  // device timer, seconds per step; empty without one
  std::map<std::string, Interval> stage_intervals = {};
  std::optional<double> timer_floor = {};  // that timer's reading of an empty kernel, seconds
  std::vector<std::string> at_floor = {};  // stages whose reading does not exceed that

  uint64_t batch() const { return plan.steps.back(); }  // K
  double median_seconds() const { return median(seconds); }
  Interval interval() const { return median_interval(seconds); }
  std::vector<std::string> unsteady() const { return spherepair::unsteady(interval(), others); }
  double device_seconds() const;  // sum of the stages, NaN without a timer
};

void add_turn(Samples& samples, Turn turn, uint64_t position);  // adds a round

// After the last round, sets the time per step of each round: the median over its batches of their time, without the
// fixed cost of the line through all batches, over their steps. Without such a line it is the longest batch over its
// steps.
void fit_rounds(Samples& samples);

json to_json(const Samples& samples);

constexpr double in_ms = 1e3;  // of a second

// A cell of a table: 1.234 [1.229, 1.240], the median with its interval, which needs 6 rounds; marked if unsteady.
std::string time_cell(const Samples& samples, double in_second = in_ms);
std::string time_cell(const std::vector<double>& seconds, double in_second, bool steady);

}  // namespace spherepair
