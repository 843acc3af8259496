// SPDX-License-Identifier: MIT
// Measures a GPU's power over a window of time by two methods: its energy counter, and its integrated power.
#pragma once

#include <functional>
#include <span>

#include "bench/gpu/gpu_meter.h"

namespace spherepair {

struct PowerSample {
  double seconds;  // of a steady clock
  double watts;
  uint64_t millijoules;
};

struct MeanPower {
  double counter, integrated;  // watts
};

// Both methods over the same time: from the first tick of the counter, which advances about every 0.1 s, to its last
// one. A counter may wrap at 2^32 or 2^64. Throws BackendError without ticks.
MeanPower mean_power(std::span<const PowerSample> samples);

struct EnergyWindow {
  MeanPower power;
  uint64_t steps = 0;
  double seconds = 0;  // that the steps took
  double step_seconds() const { return seconds / double(steps); }
};

// Works for `ahead` seconds, then for `seconds`, while a thread takes a sample every 10 ms. `work` takes some 50 ms and
// returns the number of its steps; 0 steps measure an idle GPU.
EnergyWindow measure_window(const GpuMeter& meter, double seconds, double ahead, const std::function<uint64_t()>& work);

}  // namespace spherepair
