// SPDX-License-Identifier: MIT
#include "vulkan/command_stream.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace spherepair {
namespace {

// Dispatches of a submission. Few at first, so that the device does not idle while the host records; a submission costs
// the host 6 to 12 us.
constexpr uint first_dispatches = 4, most_dispatches = 256;
constexpr size_t most_under_way = 64;
// How long the host polls a fence before it blocks: a blocking wait returns 30 to 50 us after the device is done.
constexpr std::chrono::milliseconds longest_poll{1};

struct Scope {
  VkPipelineStageFlags stages;
  VkAccessFlags access;
};

void barrier(const Calls& vk, VkCommandBuffer commands, const Scope& before, const Scope& behind) {
  auto memory = typed<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  memory.srcAccessMask = before.access;
  memory.dstAccessMask = behind.access;
  vk.CmdPipelineBarrier(commands, before.stages, behind.stages, 0, 1, &memory, 0, nullptr, 0, nullptr);
}

constexpr VkPipelineStageFlags kernels = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags transfers = VK_PIPELINE_STAGE_TRANSFER_BIT;
constexpr VkAccessFlags by_kernels = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
constexpr VkAccessFlags by_transfers = VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;

}  // namespace

void kernel_barrier(const Calls& vk, VkCommandBuffer commands) {
  barrier(vk, commands, {kernels, VK_ACCESS_SHADER_WRITE_BIT}, {kernels, by_kernels});
}

void barrier_before_transfer(const Calls& vk, VkCommandBuffer commands) {
  barrier(vk, commands, {kernels | transfers, VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT},
          {transfers, by_transfers});
}

void barrier_behind_transfer(const Calls& vk, VkCommandBuffer commands) {
  barrier(vk, commands, {transfers, VK_ACCESS_TRANSFER_WRITE_BIT},
          {kernels | transfers | VK_PIPELINE_STAGE_HOST_BIT, by_kernels | by_transfers | VK_ACCESS_HOST_READ_BIT});
}

CommandStream::CommandStream(const LogicalDevice& device)
    : device_(device), vk_(device.calls()), most_(first_dispatches) {
  auto info = typed<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  info.queueFamilyIndex = device.limits().queue_family;
  vulkan_check(vk_.CreateCommandPool(device.handle(), &info, nullptr, &pool_), "making a pool of command buffers");
}

CommandStream::~CommandStream() {
  vk_.DeviceWaitIdle(device_.handle());  // for a lost device, too
  for (const Submission& each : under_way_) vk_.DestroyFence(device_.handle(), each.fence, nullptr);
  for (VkFence fence : fences_) vk_.DestroyFence(device_.handle(), fence, nullptr);
  vk_.DestroyCommandPool(device_.handle(), pool_, nullptr);
}

VkCommandBuffer CommandStream::make() {
  auto info = typed<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  info.commandPool = pool_;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  vulkan_check(vk_.AllocateCommandBuffers(device_.handle(), &info, &commands), "making a command buffer");
  return commands;
}

void CommandStream::free(VkCommandBuffer commands) { vk_.FreeCommandBuffers(device_.handle(), pool_, 1, &commands); }

void CommandStream::begin(VkCommandBuffer commands, VkCommandBufferUsageFlags flags) const {
  auto info = typed<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  info.flags = flags;
  vulkan_check(vk_.BeginCommandBuffer(commands, &info), "beginning a command buffer");
}

void CommandStream::end(VkCommandBuffer commands) const {
  vulkan_check(vk_.EndCommandBuffer(commands), "ending a command buffer");
}

VkCommandBuffer CommandStream::open() {
  if (open_) return open_;
  if (idle_.empty()) idle_.push_back(make());
  begin(idle_.back(), VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT);
  open_ = idle_.back();
  idle_.pop_back();
  return open_;
}

void CommandStream::recorded() { count(1); }

void CommandStream::count(uint dispatches) {
  waiting_ += dispatches;
  if (waiting_ < most_) return;
  submit();
  most_ = std::min(2 * most_, most_dispatches);
}

void CommandStream::close() {
  if (!open_) return;
  const VkCommandBuffer done = std::exchange(open_, VK_NULL_HANDLE);
  ours_.push_back(done);
  end(done);
  closed_.push_back(done);
}

void CommandStream::append(VkCommandBuffer commands, uint dispatches) {
  close();
  closed_.push_back(commands);
  count(dispatches);
}

VkFence CommandStream::take_fence() {
  VkFence fence = VK_NULL_HANDLE;
  if (fences_.empty()) {
    auto info = typed<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    vulkan_check(vk_.CreateFence(device_.handle(), &info, nullptr, &fence), "making a fence");
  } else {
    fence = fences_.back();
    fences_.pop_back();
  }
  return fence;
}

void CommandStream::submit() {
  close();
  if (closed_.empty()) return;
  while (under_way_.size() >= most_under_way) finish_first();
  auto info = typed<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  info.commandBufferCount = uint32_t(closed_.size());
  info.pCommandBuffers = closed_.data();
  under_way_.push_back({next_, take_fence(), {}});
  const VkResult result = vk_.QueueSubmit(device_.queue(), 1, &info, under_way_.back().fence);
  under_way_.back().commands = std::exchange(ours_, {});
  closed_.clear();
  waiting_ = 0;
  if (result != VK_SUCCESS) {  // its fence never signals
    vk_.DestroyFence(device_.handle(), under_way_.back().fence, nullptr);
    under_way_.pop_back();
  }
  vulkan_check(result, "submitting commands");
  ++next_;
}

// Does not poll in software, where the device needs the host's threads.
void CommandStream::poll(VkFence fence) const {
  const auto clock = std::chrono::steady_clock::now;
  const auto start = clock();
  while (!device_.limits().software && vk_.GetFenceStatus(device_.handle(), fence) == VK_NOT_READY)
    if (clock() - start > longest_poll) return;
}

void CommandStream::finish_first() {
  const Submission& first = under_way_.front();
  poll(first.fence);
  vulkan_check(vk_.WaitForFences(device_.handle(), 1, &first.fence, VK_TRUE, std::numeric_limits<uint64_t>::max()),
               "waiting for the device");
  vulkan_check(vk_.ResetFences(device_.handle(), 1, &first.fence), "resetting a fence");
  fences_.push_back(first.fence);
  idle_.insert(idle_.end(), first.commands.begin(), first.commands.end());
  under_way_.pop_front();
}

void CommandStream::wait(uint64_t number) {
  if (number >= next_) submit(), most_ = first_dispatches;
  while (!under_way_.empty() && under_way_.front().number <= number) finish_first();
}

}  // namespace spherepair
