// SPDX-License-Identifier: MIT
// The timing core of all backends: host clock around K back-to-back steps between full synchronisations.
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
  std::function<void(Backend&)> step;  // enqueues one step
  bool alternates = false;  // other contenders change the backend's state: one untimed step precedes each sample
  std::function<void(Backend&)> restart = {};  // before each sample, untimed: resets the start of the sample
  uint64_t batch = 0;                          // K, if a step changes the work of the next one; 0: chosen by its time
};

struct Sampling {
  int rounds = 11;
  int fewest_rounds = 6;           // of slow contenders; the fewest that give a 95 % interval of the median
  double round_budget = 4.0;       // seconds for all rounds of one contender; if it takes longer, fewest_rounds
  uint64_t hardware_batch = 100;   // least K on a GPU
  double hardware_seconds = 2e-3;  // minimum duration of a sample on a GPU
  double hardware_peak = 0.25;     // hardware_batch is reduced if it would take longer than this
  double software_seconds = 0.05;  // minimum duration of a sample on the CPU
  double narrow_enough = 0;        // share of the median: after fewest_rounds, stop when no interval is wider
  uint64_t seed = 1;               // of the order within rounds
};

struct Samples {
  std::string label, backend;
  uint64_t batch = 0;                    // K
  std::vector<double> seconds;           // per step, one value per round
  std::vector<uint64_t> turn;            // position of each value in the sequence of all samples
  std::map<std::string, double> stages;  // device timer, seconds per step; empty without one
  std::map<std::string, Interval> stage_intervals;

  double median_seconds() const { return median(seconds); }
  Interval interval() const { return median_interval(seconds); }
  double device_seconds() const;  // sum of the stages, NaN without a timer
};
json to_json(const Samples& samples);

// Seconds of `batch` steps, from and to an idle device. On a GPU, three untimed steps precede a batch of several, so
// that neither the switch from another API's work nor the capture of a graph is timed.
double time_batch(const Contender& contender, uint64_t batch);
uint64_t choose_batch(const Contender& contender, const Sampling& sampling);

// Warms up, then takes a sample of each contender per round, in a new random order each round.
std::vector<Samples> measure(std::span<const Contender> contenders, const Sampling& sampling, Progress& progress);

// Predicted seconds of measuring the same contenders when each step takes `growth` times as long.
double predict_seconds(std::span<const Samples> samples, double growth, const Sampling& sampling);

// What the samples of one measure() say of the times of two contenders. A load that lasts longer than a round slows
// down both samples of that round, so it is the ratios within the rounds that are looked at.
enum class Finding {
  differ,  // the interval of the rounds' ratios is on one side of 1, and so say the medians' intervals or the ranks
  no_difference,  // the interval holds 1 and is narrow
  undecided       // it is wide, or of too few rounds to be one
};
struct Contest {
  Finding finding;
  double ratio, p;          // left's median over right's; of the rank test
  Interval ratios;          // of the median of the rounds' ratios
  size_t rounds;            // that both took part in
  std::string left, right;  // backends
};
Contest contest(const Samples& left, const Samples& right);
bool enough_rounds(const Contest& contest);       // for an interval of 95 %
std::string spread_text(const Contest& contest);  // 0.54x to 2.10x in 7 rounds
// 1.07x, "no difference seen", or "undecided: 0.54x to 2.10x": cells of tables, and so short.
std::string ratio_text(const Contest& contest);
std::string verdict(const Contest& contest);  // the same, but "glsl takes 1.07x cuda's time"

}  // namespace spherepair
