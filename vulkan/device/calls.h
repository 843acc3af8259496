// SPDX-License-Identifier: MIT
// Vulkan's functions. The loader is opened on first use, so that the program also starts without one.
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>

#include <string>

namespace spherepair {

// clang-format off
#define SPHEREPAIR_VULKAN_GLOBAL(each) \
  each(CreateInstance) each(EnumerateInstanceVersion)
#define SPHEREPAIR_VULKAN_INSTANCE(each) \
  each(DestroyInstance) each(EnumeratePhysicalDevices) each(EnumerateDeviceExtensionProperties) \
  each(GetPhysicalDeviceProperties2) each(GetPhysicalDeviceFeatures2) each(GetPhysicalDeviceMemoryProperties2) \
  each(GetPhysicalDeviceQueueFamilyProperties) each(CreateDevice) each(GetDeviceProcAddr)
#define SPHEREPAIR_VULKAN_OPTIONAL(each) each(GetPhysicalDeviceCooperativeMatrixPropertiesNV) each(GetMemoryFdKHR)
#define SPHEREPAIR_VULKAN_DEVICE(each) \
  each(DestroyDevice) each(GetDeviceQueue) each(DeviceWaitIdle) each(QueueSubmit) \
  each(CreateFence) each(DestroyFence) each(ResetFences) each(WaitForFences) each(GetFenceStatus) \
  each(AllocateMemory) each(FreeMemory) each(MapMemory) \
  each(CreateBuffer) each(DestroyBuffer) each(GetBufferMemoryRequirements) each(BindBufferMemory) \
  each(CreateBufferView) each(DestroyBufferView) \
  each(CreateShaderModule) each(DestroyShaderModule) each(CreateComputePipelines) each(DestroyPipeline) \
  each(CreatePipelineLayout) each(DestroyPipelineLayout) \
  each(CreateDescriptorSetLayout) each(DestroyDescriptorSetLayout) each(CreateDescriptorPool) \
  each(DestroyDescriptorPool) each(AllocateDescriptorSets) each(UpdateDescriptorSets) \
  each(CreateCommandPool) each(DestroyCommandPool) each(AllocateCommandBuffers) each(FreeCommandBuffers) \
  each(BeginCommandBuffer) each(EndCommandBuffer) \
  each(CmdBindPipeline) each(CmdBindDescriptorSets) each(CmdDispatch) each(CmdPipelineBarrier) \
  each(CmdCopyBuffer) each(CmdFillBuffer) each(CmdResetQueryPool) each(CmdWriteTimestamp) \
  each(CreateQueryPool) each(DestroyQueryPool) each(GetQueryPoolResults)
// clang-format on

struct Calls {
#define POINTER(name) PFN_vk##name name = nullptr;
  SPHEREPAIR_VULKAN_GLOBAL(POINTER)
  SPHEREPAIR_VULKAN_INSTANCE(POINTER)
  SPHEREPAIR_VULKAN_OPTIONAL(POINTER)  // null where the driver does not know it
  SPHEREPAIR_VULKAN_DEVICE(POINTER)
#undef POINTER

  void load_global();  // throws BackendError that says what to install
  void load_of(VkInstance instance);
  void load_of(VkDevice device);
};

// A Vulkan struct of this type, its other members 0.
template <typename Struct>
Struct typed(VkStructureType type) {
  Struct made{};
  made.sType = type;
  return made;
}

// Throws BackendError unless the call succeeded; `what` names the action ("allocating 64 bytes").
void vulkan_check(VkResult result, const std::string& what);

}  // namespace spherepair
