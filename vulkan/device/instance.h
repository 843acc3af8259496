// SPDX-License-Identifier: MIT
// The Vulkan instance, and the choice of a device.
#pragma once

#include <set>
#include <vector>

#include "common/backend/backend.h"
#include "vulkan/device/calls.h"

namespace spherepair {

class Instance {
 public:
  Instance();  // throws BackendError without a loader, a driver or Vulkan 1.1
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  // The device that options.vulkan_device names, else the first: GPUs before software, or software alone if GPUs are
  // not allowed. Throws BackendError that lists the devices.
  VkPhysicalDevice choose(const OpenOptions& options) const;

  Calls calls;

 private:
  std::vector<VkPhysicalDevice> in_order(bool allow_gpu) const;

  VkInstance instance_ = VK_NULL_HANDLE;
};

VkPhysicalDeviceProperties properties_of(const Calls& vk, VkPhysicalDevice device);
std::string uuid_of(const Calls& vk, VkPhysicalDevice device);  // 32 hex digits
std::set<std::string> extensions_of(const Calls& vk, VkPhysicalDevice device);
inline bool in_software(const VkPhysicalDeviceProperties& properties) {
  return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}
std::string api_version_text(uint32_t version);

}  // namespace spherepair
