// SPDX-License-Identifier: MIT
// Commands in the order in which the device runs them. They are recorded into command buffers, which go out when they
// are long enough, or when something is waited for.
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

  // Counts submissions from 1 on: the number of the one that what is recorded now will be part of.
  uint64_t number() const { return next_; }

  VkCommandBuffer open();  // to record into
  void recorded();         // a dispatch, a copy or the like; may submit
  void submit();           // what was recorded, if anything was
  void wait(uint64_t number);
  void wait() { wait(next_); }

  // A command buffer of the caller's, which may go out many times.
  VkCommandBuffer make();
  void begin(VkCommandBuffer commands, VkCommandBufferUsageFlags flags) const;
  void end(VkCommandBuffer commands) const;
  void append(VkCommandBuffer commands, uint dispatches);
  void free(VkCommandBuffer commands);  // must not be under way

 private:
  struct Submission {
    uint64_t number;
    VkFence fence;
    std::vector<VkCommandBuffer> commands;  // to be recorded anew afterwards
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
  std::vector<VkCommandBuffer> closed_;  // to go out next, in this order
  std::vector<VkCommandBuffer> ours_;    // of these, those to be recorded anew
  std::vector<VkCommandBuffer> idle_;
  std::vector<VkFence> fences_;  // unsignalled
  std::deque<Submission> under_way_;
  uint64_t next_ = 1;
  uint waiting_ = 0;  // dispatches that have not gone out
  uint most_;         // of them, before they do
};

// Barriers: what kernels have written is seen by those behind; by a transfer behind; what a transfer has written, by
// all behind and by the host.
void kernel_barrier(const Calls& vk, VkCommandBuffer commands);
void barrier_before_transfer(const Calls& vk, VkCommandBuffer commands);
void barrier_behind_transfer(const Calls& vk, VkCommandBuffer commands);

}  // namespace spherepair
