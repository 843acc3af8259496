// SPDX-License-Identifier: MIT
// The timing core, one for all backends: host clock over K back-to-back steps between full synchronisations.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "bench/io/report.h"
#include "bench/measure/statistics.h"
#include "common/backend/backend.h"

namespace spherepair {

struct Contender {
  std::string label;
  Backend* backend;
  std::function<void(Backend&)> step;          // enqueues one step
  bool alternates = false;                     // others leave the backend in another state: a step goes ahead, untimed
  std::function<void(Backend&)> restart = {};  // before each sample, untimed: where all are to begin
  uint64_t batch = 0;  // K, where a step changes what the next one has to do; 0: by the time it takes
};

struct Sampling {
  int rounds = 11;
  int fewest_rounds = 6;           // of slow contenders; fewer give no 95 % interval of the median
  double round_budget = 4.0;       // seconds for all rounds of one contender before they are cut to the fewest
  uint64_t hardware_batch = 100;   // K at least, on a GPU
  double hardware_seconds = 2e-3;  // a sample lasts at least this long, on a GPU
  double hardware_peak = 0.25;     // K shrinks again when the least K would last longer than this
  double software_seconds = 0.05;  // a sample lasts at least this long on the CPU
  double narrow_enough = 0;        // share of the median; rounds end, after the fewest, when no interval is wider
  uint64_t seed = 1;               // of the order within rounds
};

struct Samples {
  std::string label, backend;
  uint64_t batch = 0;                    // K
  std::vector<double> seconds;           // per step, one value a round
  std::vector<uint64_t> turn;            // at which place of the whole run each value was taken
  std::map<std::string, double> stages;  // device timer, seconds per step; empty without one
  std::map<std::string, Interval> stage_intervals;

  double median_seconds() const { return median(seconds); }
  Interval interval() const { return median_interval(seconds); }
  double device_seconds() const;  // sum of the stages, NaN without a timer
};
json to_json(const Samples& samples);

// Seconds that `batch` steps take, from and to an idle device; on a GPU behind three more that are not timed, where
// they are more than one, so that neither the way back from another API's work nor the making of a graph is among them.
double time_batch(const Contender& contender, uint64_t batch);
uint64_t choose_batch(const Contender& contender, const Sampling& sampling);

// Warm-up apart, then rounds in which every contender takes its turn, in a new random order each round.
std::vector<Samples> measure(std::span<const Contender> contenders, const Sampling& sampling, Progress& progress);

// Seconds that measuring the same contenders will take when each step takes `growth` times as long.
double predict_seconds(std::span<const Samples> samples, double growth, const Sampling& sampling);

// Two differ only when the intervals of their medians are apart or the rank test says p < 0.01.
struct Contest {
  bool differ;
  double ratio, p;   // right's median over left's; of the rank test
  std::string text;  // e.g. "glsl 4.2 % slower", "no difference seen"
};
Contest contest(const Samples& left, const Samples& right);

}  // namespace spherepair
