// SPDX-License-Identifier: MIT
// The power of a GPU over a window of time, by two methods: its energy counter, and its power integrated.
#pragma once

#include <functional>
#include <span>

#include "bench/gpu/power_meter.h"

namespace spherepair {

struct PowerSample {
  double seconds;  // of a steady clock
  double watts;
  uint64_t millijoules;
};

struct MeanPower {
  double counter, integrated;  // watts
};

// Both over the same time: from the first tick of the counter, which moves in steps of some 0.1 s, to its last one. A
// counter that begins anew at 2^32 or 2^64 goes on. Throws BackendError without ticks.
MeanPower mean_power(std::span<const PowerSample> samples);

struct EnergyWindow {
  MeanPower power;
  uint64_t steps = 0;
  double seconds = 0;  // that they took
  double step_seconds() const { return seconds / double(steps); }
};

// Works for `ahead` seconds, then for `seconds`, while a thread takes a sample every 10 ms. `work` takes some
// 50 ms and returns the number of its steps; 0 for none, whose power is that of an idle GPU.
EnergyWindow measure_window(const PowerMeter& meter, double seconds, double ahead,
                            const std::function<uint64_t()>& work);

}  // namespace spherepair
