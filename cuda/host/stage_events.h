// SPDX-License-Identifier: MIT
// Times stages with CUDA events on the default stream. While it is off, it records no events.
#pragma once

#include <vector>

#include "cuda/host/check.h"

namespace spherepair {

class StageEvents {
 public:
  StageEvents() = default;
  ~StageEvents() { forget(); }
  StageEvents(const StageEvents&) = delete;
  StageEvents& operator=(const StageEvents&) = delete;

  void turn(bool on) { on_ = on; }
  bool on() const { return on_; }

  // Runs the work and records its time as a stage with this name.
  template <typename Work>
  void time(const char* name, Work work) {
    if (!on_) return work();
    Stage stage{name, nullptr, nullptr};
    cuda_check(cudaEventCreate(&stage.start), "creating an event");
    cuda_check(cudaEventCreate(&stage.stop), "creating an event");
    cuda_check(cudaEventRecord(stage.start), "recording an event");
    work();
    cuda_check(cudaEventRecord(stage.stop), "recording an event");
    stages_.push_back(stage);
  }

  // Returns the device times of the stages since the last call, in the order of launch. The device must have finished
  // them.
  std::vector<StageTime> take() {
    std::vector<StageTime> times;
    for (const Stage& stage : stages_) {
      float milliseconds = 0;
      cuda_check(cudaEventElapsedTime(&milliseconds, stage.start, stage.stop), "reading an event");
      times.push_back({stage.name, milliseconds * 1e-3});
    }
    forget();
    return times;
  }

 private:
  struct Stage {
    const char* name;
    cudaEvent_t start, stop;
  };
  void forget() {
    for (const Stage& stage : stages_) {
      cudaEventDestroy(stage.start);
      cudaEventDestroy(stage.stop);
    }
    stages_.clear();
  }
  bool on_ = false;
  std::vector<Stage> stages_;
};

}  // namespace spherepair
