// SPDX-License-Identifier: MIT
// Opens the device and its one queue.
#pragma once

#include "vulkan/device/device_limits.h"

namespace spherepair {

class LogicalDevice {
 public:
  explicit LogicalDevice(const OpenOptions& options);
  ~LogicalDevice();
  LogicalDevice(const LogicalDevice&) = delete;
  LogicalDevice& operator=(const LogicalDevice&) = delete;

  const Calls& calls() const { return instance_.calls; }
  const DeviceLimits& limits() const { return limits_; }
  VkPhysicalDevice physical() const { return physical_; }
  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  const std::string& spirv_folder() const { return spirv_folder_; }  // see OpenOptions

 private:
  Instance instance_;
  VkPhysicalDevice physical_;
  DeviceLimits limits_;
  std::string spirv_folder_;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
};

}  // namespace spherepair
