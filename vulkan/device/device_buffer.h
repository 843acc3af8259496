// SPDX-License-Identifier: MIT
// Buffers, each with memory of its own.
#pragma once

#include <memory>
#include <unordered_map>

#include "vulkan/device/logical_device.h"

namespace spherepair {

enum class Place {
  device,      // of kernels alone
  uploads,     // the host writes, the device reads a few times; mapped, as all below
  downloads,   // the device writes, the host reads
  parameters,  // the host writes, kernels read: in the device's memory where the host reaches that
  exported     // of the device, to be imported by another API; not mapped
};

class DeviceBuffer {
 public:
  // Throws BackendError with the bytes asked and free.
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

// Buffers of kernels by handles that are never used again, as Vulkan's own may be: what was recorded with a buffer that
// is gone is never taken for what another needs.
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
