// SPDX-License-Identifier: MIT
#include "vulkan/device/logical_device.h"

#include <fmt/format.h>

namespace spherepair {

LogicalDevice::LogicalDevice(const OpenOptions& options)
    : physical_(instance_.choose(options)),
      limits_(device_limits(instance_.calls, physical_, options)),
      spirv_folder_(options.spirv_folder) {
  const WantedFeatures wanted(limits_);
  const float priority = 1;
  auto queue = typed<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueFamilyIndex = limits_.queue_family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  auto info = typed<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  info.pNext = &wanted.features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = uint32_t(wanted.extensions.size());
  info.ppEnabledExtensionNames = wanted.extensions.data();
  vulkan_check(instance_.calls.CreateDevice(physical_, &info, nullptr, &device_),
               fmt::format("opening {}", limits_.properties.deviceName));
  instance_.calls.load_of(device_);
  calls().GetDeviceQueue(device_, limits_.queue_family, 0, &queue_);
}

LogicalDevice::~LogicalDevice() { calls().DestroyDevice(device_, nullptr); }

}  // namespace spherepair
