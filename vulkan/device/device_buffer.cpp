// SPDX-License-Identifier: MIT
#include "vulkan/device/device_buffer.h"

#include <fmt/format.h>

namespace spherepair {
namespace {

constexpr VkMemoryPropertyFlags local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags mapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

struct Wish {
  VkMemoryPropertyFlags has, lacks;
};

// Lists memory types by preference. Buffers of kernels avoid memory that the host maps: some GPUs have little of it.
std::vector<Wish> wishes(Place place) {
  switch (place) {
    case Place::device:
    case Place::exported:
      return {{local, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT}, {local, 0}, {0, 0}};
    case Place::uploads:
      return {{mapped, local}, {mapped, 0}};
    case Place::downloads:
      return {{mapped | cached, 0}, {mapped, 0}};
    case Place::parameters:
      return {{mapped | local, 0}, {mapped, 0}};
  }
  return {};
}

VkBufferUsageFlags usage(Place place) {
  if (place == Place::parameters) return VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const VkBufferUsageFlags copies = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (place != Place::device) return copies;
  return copies | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
}

struct MemoryState {
  VkPhysicalDeviceMemoryProperties properties;
  std::vector<VkDeviceSize> free;  // bytes by heap; empty if the driver does not report them
};

MemoryState memory_of(const LogicalDevice& device) {
  auto budget =
      typed<VkPhysicalDeviceMemoryBudgetPropertiesEXT>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT);
  auto all = typed<VkPhysicalDeviceMemoryProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2);
  const bool told = device.limits().memory_budget;
  if (told) all.pNext = &budget;
  device.calls().GetPhysicalDeviceMemoryProperties2(device.physical(), &all);
  MemoryState state{all.memoryProperties, {}};
  for (uint32_t heap = 0; told && heap < all.memoryProperties.memoryHeapCount; ++heap) {
    const VkDeviceSize most = budget.heapBudget[heap], used = budget.heapUsage[heap];
    state.free.push_back(most > used ? most - used : 0);
  }
  return state;
}

uint32_t memory_type(const MemoryState& memory, uint32_t allowed, Place place) {
  for (const Wish& wish : wishes(place))
    for (uint32_t type = 0; type < memory.properties.memoryTypeCount; ++type) {
      const VkMemoryPropertyFlags flags = memory.properties.memoryTypes[type].propertyFlags;
      if ((allowed >> type & 1) && (flags & wish.has) == wish.has && !(flags & wish.lacks)) return type;
    }
  throw BackendError("vulkan: the device has no memory that the host can map; update the driver");
}

bool is_full(VkResult result) {
  return result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY;
}

std::string out_of_memory(const MemoryState& memory, uint32_t type, uint64_t bytes) {
  const std::string free = memory.free.empty()
                               ? "this driver does not say how many are free"
                               : fmt::format("{} free", memory.free[memory.properties.memoryTypes[type].heapIndex]);
  return fmt::format("vulkan: out of memory: {} bytes asked, {}; use fewer spheres or no pair list", bytes, free);
}

}  // namespace

DeviceBuffer::DeviceBuffer(const LogicalDevice& device, uint64_t bytes, Place place) : device_(device), bytes_(bytes) {
  try {
    make(place);
  } catch (const BackendError&) {
    release();
    throw;
  }
}

void DeviceBuffer::make(Place place) {
  const Calls& vk = device_.calls();
  auto info = typed<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = bytes_;
  info.usage = usage(place);
  auto external = typed<VkExternalMemoryBufferCreateInfo>(VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_BUFFER_CREATE_INFO);
  external.handleTypes = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
  if (place == Place::exported) info.pNext = &external;
  vulkan_check(vk.CreateBuffer(device_.handle(), &info, nullptr, &buffer_), fmt::format("making {} bytes", bytes_));
  VkMemoryRequirements needs;
  vk.GetBufferMemoryRequirements(device_.handle(), buffer_, &needs);
  const MemoryState memory = memory_of(device_);
  auto wanted = typed<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
  wanted.allocationSize = allocated_ = needs.size;
  auto dedicated = typed<VkMemoryDedicatedAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO);
  dedicated.buffer = buffer_;
  auto exported = typed<VkExportMemoryAllocateInfo>(VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO);
  exported.handleTypes = external.handleTypes;
  exported.pNext = &dedicated;
  if (place == Place::exported) wanted.pNext = &exported;
  wanted.memoryTypeIndex = memory_type(memory, needs.memoryTypeBits, place);
  const VkResult result = vk.AllocateMemory(device_.handle(), &wanted, nullptr, &memory_);
  if (is_full(result)) throw BackendError(out_of_memory(memory, wanted.memoryTypeIndex, bytes_));
  vulkan_check(result, fmt::format("allocating {} bytes", bytes_));
  vulkan_check(vk.BindBufferMemory(device_.handle(), buffer_, memory_, 0), fmt::format("binding {} bytes", bytes_));
  if (place == Place::device || place == Place::exported) return;
  void* address = nullptr;
  vulkan_check(vk.MapMemory(device_.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &address),
               fmt::format("mapping {} bytes", bytes_));
  mapped_ = static_cast<char*>(address);
}

int DeviceBuffer::descriptor() const {
  auto info = typed<VkMemoryGetFdInfoKHR>(VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR);
  info.memory = memory_;
  info.handleType = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
  int descriptor = -1;
  vulkan_check(device_.calls().GetMemoryFdKHR(device_.handle(), &info, &descriptor),
               fmt::format("exporting {} bytes", bytes_));
  return descriptor;
}

void DeviceBuffer::release() {
  device_.calls().DestroyBuffer(device_.handle(), buffer_, nullptr);
  device_.calls().FreeMemory(device_.handle(), memory_, nullptr);
  buffer_ = VK_NULL_HANDLE, memory_ = VK_NULL_HANDLE;
}

}  // namespace spherepair
