// SPDX-License-Identifier: MIT
// Where the time of `spherepair run` goes.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "bench/io/report.h"
#include "common/backend/backend.h"

namespace spherepair {

class RunTimes {
 public:
  // Runs the work and adds its wall-clock seconds to those of its kind.
  enum Part { spheres, opening, moves, searches, states, parts };
  template <typename Work>
  auto spend(Part part, Work work) {
    struct Watch {
      double& seconds;
      std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
      ~Watch() { seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
    } watch{seconds_[part]};
    return work();
  }
  void count(Part part, uint64_t times) { counts_[part] += times; }

  // Sets the times of the last step's kernels: by the device's timers on a GPU, by the host's clock on the CPU.
  void set_stages(const Backend& backend, std::vector<StageTime> stages);

  std::string text() const;
  double total() const;
  json to_json() const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double seconds_[parts] = {};
  uint64_t counts_[parts] = {};
  std::vector<StageTime> stages_;  // one a kernel, summed
  bool by_device_ = false;
};

}  // namespace spherepair
