// SPDX-License-Identifier: MIT
// Times stages by the device's timestamps. Takes no times while it is off.
#pragma once

#include "vulkan/command_stream.h"

namespace spherepair {

class StageQueries {
 public:
  explicit StageQueries(const LogicalDevice& device);
  ~StageQueries();
  StageQueries(const StageQueries&) = delete;
  StageQueries& operator=(const StageQueries&) = delete;

  void turn(bool on) { on_ = on && device_.limits().timestamp_bits != 0; }
  bool on() const { return on_; }
  bool full() const { return stages_.size() == most_stages; }  // call collect() before the next stage

  // Records the work and times it as a stage of this name.
  template <typename Work>
  void time(const char* name, VkCommandBuffer commands, Work work) {
    if (!on_) return work();
    const uint32_t first = 2 * uint32_t(stages_.size());
    stages_.push_back(name);
    device_.calls().CmdResetQueryPool(commands, pool_, first, 2);
    stamp(commands, first);
    work();
    stamp(commands, first + 1);
  }

  void collect();                 // reads the times of all stages, which the device must have finished
  std::vector<StageTime> take();  // the collected times, in order

 private:
  static constexpr size_t most_stages = 2048;
  void stamp(VkCommandBuffer commands, uint32_t query) const;

  const LogicalDevice& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  bool on_ = false;
  std::vector<const char*> stages_;
  std::vector<StageTime> times_;
};

}  // namespace spherepair
