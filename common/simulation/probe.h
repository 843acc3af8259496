// SPDX-License-Identifier: MIT
// Kernels that measure: the predicate alone, an empty launch, and the device's peak rates.
#pragma once

#include "common/device/context.h"

namespace spherepair {

class Probe {
 public:
  explicit Probe(DeviceContext& context) : context_(context) {}

  void upload();
  std::vector<uint> decide(std::span<const vec4> spheres);
  void launch_empty(uint groups);
  void enqueue_empty_step(uint launches, const ApiOptions& api);

  // Overwrites velocities or counts. check_peak_rate throws BackendError if the result is wrong.
  void launch_peak_rate(PeakRate rate);
  void check_peak_rate(PeakRate rate);

 private:
  bool copied_right(PeakRate rate);

  DeviceContext& context_;
};

}  // namespace spherepair
