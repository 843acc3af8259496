// SPDX-License-Identifier: MIT
// Measures a backend and checks its kernels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/backend/collide_options.h"
#include "common/backend/preparations.h"

namespace spherepair {

struct StageTime {
  std::string stage;  // the kernel's name
  double seconds;     // by the device's own timer
};

// The peak rates of a device that kernels measure: copying 16 bytes a sphere, one scattered atomic a sphere,
// multiply-adds in registers, and the same copy one 4-byte word at a time.
enum class PeakRate { copy, atomics, issue, words };

// The kernels that measure peak rates. They overwrite velocities and counts.
class PeakRateKernels {
 public:
  virtual ~PeakRateKernels() = default;
  virtual void launch(PeakRate rate) = 0;
  virtual void check(PeakRate rate) = 0;  // launches it once; throws BackendError when its result is wrong
};

class Instruments {
 public:
  virtual ~Instruments() = default;

  // Decides spheres[2k] against spheres[2k + 1] with the kernels' code; returns a verdict_code() for every k.
  virtual std::vector<uint> decide(std::span<const vec4> spheres) = 0;

  // Launch empty kernels, to measure what launches cost: a single one, or a step of several dependent ones.
  virtual void launch_empty(uint groups) = 0;
  virtual void enqueue_empty_step(uint launches, const ApiOptions& api) = 0;
  virtual PeakRateKernels* peak_rates() { return nullptr; }  // null: a backend without a device

  // Throws BackendError, which names the buffer, if a kernel wrote past its end, where guard words stand.
  virtual void check_guards() = 0;

  virtual WorkCounts work_counts() const = 0;
  virtual Preparations preparations() const = 0;

  // Returns the host seconds that each kernel takes to compile for groups of 128; empty if the build compiles them.
  virtual std::vector<StageTime> compile_kernels() { return {}; }

  // While timing is on, the device's timer brackets every kernel. stage_times() returns the times since its last call,
  // in order.
  virtual void time_stages(bool on) = 0;
  virtual std::vector<StageTime> stage_times() = 0;
};

}  // namespace spherepair
