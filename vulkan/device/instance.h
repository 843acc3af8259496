// SPDX-License-Identifier: MIT
// Vulkan itself, and the device that is taken of those that it reaches.
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

  // The one that options.vulkan_device names, else the first: GPUs before software, which alone counts where no GPU is
  // allowed. Throws BackendError with those that are there.
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
