// SPDX-License-Identifier: MIT
// Collects commands in the order in which the device runs them. Command buffers are submitted when they are long
// enough, or when the host waits for one of them.
#pragma once

#include <deque>
#include <vector>

#include "vulkan/device/logical_device.h"

namespace spherepair {

class CommandStream {
 public:
  explicit CommandStream(const LogicalDevice& device);
  ~CommandStream();
  CommandStream(const CommandStream&) = delete;
  CommandStream& operator=(const CommandStream&) = delete;

  // The number of the next submission, counted from 1: it will hold the commands that are recorded now.
  uint64_t number() const { return next_; }

  VkCommandBuffer open();  // the command buffer to record into
  void recorded();         // call this after each dispatch, copy or similar; may submit
  void submit();           // submits all recorded commands; none: does nothing
  void wait(uint64_t number);
  void wait() { wait(next_); }

  // Makes a command buffer that the caller records and may submit many times.
  VkCommandBuffer make();
  void begin(VkCommandBuffer commands, VkCommandBufferUsageFlags flags) const;
  void end(VkCommandBuffer commands) const;
  void append(VkCommandBuffer commands, uint dispatches);
  void free(VkCommandBuffer commands);  // the device must have finished it

 private:
  struct Submission {
    uint64_t number;
    VkFence fence;
    std::vector<VkCommandBuffer> commands;  // can be recorded anew once the device has finished them
  };
  void close();
  void count(uint dispatches);
  VkFence take_fence();
  void poll(VkFence fence) const;
  void finish_first();

  const LogicalDevice& device_;
  const Calls& vk_;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer open_ = VK_NULL_HANDLE;
  std::vector<VkCommandBuffer> closed_;  // to submit next, in this order
  std::vector<VkCommandBuffer> ours_;    // those of closed_ that can be recorded anew afterwards
  std::vector<VkCommandBuffer> idle_;
  std::vector<VkFence> fences_;  // unsignalled
  std::deque<Submission> under_way_;
  uint64_t next_ = 1;
  uint waiting_ = 0;  // dispatches that are not submitted yet
  uint most_;         // the number of them at which they are submitted
};

// Barriers. kernel_barrier: later kernels see earlier kernels' writes. barrier_before_transfer: transfers see all
// earlier writes. barrier_behind_transfer: kernels, transfers and the host see what transfers wrote.
void kernel_barrier(const Calls& vk, VkCommandBuffer commands);
void barrier_before_transfer(const Calls& vk, VkCommandBuffer commands);
void barrier_behind_transfer(const Calls& vk, VkCommandBuffer commands);

}  // namespace spherepair
