// SPDX-License-Identifier: MIT
// Buffers, each with its own memory.
#pragma once

#include <memory>
#include <unordered_map>

#include "vulkan/device/logical_device.h"

namespace spherepair {

enum class Place {
  device,      // only kernels use it
  uploads,     // the host writes, the device reads a few times; mapped, as the next two
  downloads,   // the device writes, the host reads
  parameters,  // the host writes, kernels read: in the device's memory if the host can map that
  exported     // device memory that another API imports; not mapped
};

class DeviceBuffer {
 public:
  // Throws BackendError with the bytes requested and free.
  DeviceBuffer(const LogicalDevice& device, uint64_t bytes, Place place);
  ~DeviceBuffer() { release(); }
  DeviceBuffer(const DeviceBuffer&) = delete;
  DeviceBuffer& operator=(const DeviceBuffer&) = delete;

  VkBuffer handle() const { return buffer_; }
  char* mapped() const { return mapped_; }
  uint64_t bytes() const { return bytes_; }
  uint64_t allocated() const { return allocated_; }  // bytes of its memory
  int descriptor() const;                            // of an exported buffer's memory; the caller closes it

 private:
  void make(Place place);
  void release();

  const LogicalDevice& device_;
  uint64_t bytes_, allocated_ = 0;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  char* mapped_ = nullptr;
};

// Buffers of kernels by handles that are never reused. Vulkan may reuse its own handles, so that a recording with a
// deleted buffer would be mistaken for one with a new buffer.
class BufferTable {
 public:
  explicit BufferTable(const LogicalDevice& device) : device_(device) {}
  uint64_t add(uint64_t bytes) {
    buffers_.emplace(next_, std::make_unique<DeviceBuffer>(device_, bytes, Place::device));
    return next_++;
  }
  void remove(uint64_t handle) { buffers_.erase(handle); }
  VkBuffer at(uint64_t handle) const { return buffers_.at(handle)->handle(); }

 private:
  const LogicalDevice& device_;
  uint64_t next_ = 1;
  std::unordered_map<uint64_t, std::unique_ptr<DeviceBuffer>> buffers_;
};

}  // namespace spherepair
