// SPDX-License-Identifier: MIT
// Limits and features of a device that matter to kernels and the host.
#pragma once

#include "common/backend/backend.h"
#include "common/device/device.h"
#include "vulkan/device/instance.h"
#include "vulkan/spirv/module.h"

namespace spherepair {

struct DeviceLimits {
  VkPhysicalDeviceProperties properties{};
  std::string uuid, driver;
  bool software = false;
  uint64_t largest_binding = 0;  // bytes of a storage buffer
  uint64_t largest_texture = 0;  // elements of a texel buffer
  uint32_t queue_family = 0;
  uint32_t timestamp_bits = 0;  // 0: the queue has no clock
  bool atomics_64 = false, subgroups = false, memory_budget = false;
  bool exports_memory = false;  // to other APIs, through file descriptors
  uint32_t tensor_groups = 0;   // of collide_tensor that run at once; 0: not supported
  FloatControls floats;
};

// Throws BackendError for a device without what every kernel needs.
DeviceLimits device_limits(const Calls& vk, VkPhysicalDevice device, const OpenOptions& options);

// The features that the logical device enables. `features` points to the other members, so there is no copying.
struct WantedFeatures {
  explicit WantedFeatures(const DeviceLimits& limits);
  WantedFeatures(const WantedFeatures&) = delete;
  WantedFeatures& operator=(const WantedFeatures&) = delete;

  std::vector<const char*> extensions;
  VkPhysicalDeviceFeatures2 features = typed<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);

 private:
  VkPhysicalDeviceShaderAtomicInt64Features atomics_64_ =
      typed<VkPhysicalDeviceShaderAtomicInt64Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_ATOMIC_INT64_FEATURES);
  VkPhysicalDeviceCooperativeMatrixFeaturesNV matrices_ = typed<VkPhysicalDeviceCooperativeMatrixFeaturesNV>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COOPERATIVE_MATRIX_FEATURES_NV);
  VkPhysicalDeviceVulkanMemoryModelFeatures memory_model_ =
      typed<VkPhysicalDeviceVulkanMemoryModelFeatures>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_MEMORY_MODEL_FEATURES);
  VkPhysicalDeviceShaderFloat16Int8Features halves_ =
      typed<VkPhysicalDeviceShaderFloat16Int8Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_FLOAT16_INT8_FEATURES);
};

BackendInfo describe_device(const DeviceLimits& limits);
DeviceCapabilities capabilities_of(const DeviceLimits& limits);

}  // namespace spherepair
