// SPDX-License-Identifier: MIT
#include "vulkan/device/instance.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/backend/device_name.h"

namespace spherepair {
namespace {

constexpr uint32_t least_version = VK_API_VERSION_1_1;

int rank(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return 4;
    default:
      return 3;
  }
}

std::string why_no_instance(VkResult result) {
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
    return "vulkan: the loader finds no driver; install the GPU's, or mesa-vulkan-drivers for software, and see that "
           "its file is in /usr/share/vulkan/icd.d or /etc/vulkan/icd.d";
  return {};
}

}  // namespace

Instance::Instance() {
  calls.load_global();
  uint32_t version = 0;
  vulkan_check(calls.EnumerateInstanceVersion(&version), "asking the loader for its version");
  if (version < least_version)
    throw BackendError(fmt::format("vulkan: the loader offers Vulkan {}, but 1.1 is needed; update libvulkan1",
                                   api_version_text(version)));
  auto application = typed<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.pApplicationName = "spherepair";
  application.apiVersion = VK_API_VERSION_1_2;  // the newest version in use
  auto info = typed<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;
  const VkResult result = calls.CreateInstance(&info, nullptr, &instance_);
  if (const std::string reason = why_no_instance(result); !reason.empty()) throw BackendError(reason);
  vulkan_check(result, "making an instance");
  calls.load_of(instance_);
}

Instance::~Instance() {
  if (instance_) calls.DestroyInstance(instance_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::in_order(bool allow_gpu) const {
  uint32_t count = 0;
  vulkan_check(calls.EnumeratePhysicalDevices(instance_, &count, nullptr), "counting devices");
  std::vector<VkPhysicalDevice> devices(count);
  vulkan_check(calls.EnumeratePhysicalDevices(instance_, &count, devices.data()), "listing devices");
  devices.resize(count);
  std::erase_if(devices, [&](VkPhysicalDevice device) {
    const VkPhysicalDeviceProperties properties = properties_of(calls, device);
    return properties.apiVersion < least_version || (!allow_gpu && !in_software(properties));
  });
  std::ranges::stable_sort(devices, {},
                           [&](VkPhysicalDevice device) { return rank(properties_of(calls, device).deviceType); });
  return devices;
}

VkPhysicalDevice Instance::choose(const OpenOptions& options) const {
  const DeviceName wanted(options.vulkan_device);
  uint number = 0;
  std::string found, software;
  for (VkPhysicalDevice device : in_order(options.allow_gpu)) {
    const VkPhysicalDeviceProperties properties = properties_of(calls, device);
    const bool refused = in_software(properties) && options.require_hardware;
    const std::string uuid = uuid_of(calls, device);
    const bool named = wanted.number ? number == *wanted.number : wanted.uuid == uuid;
    if ((wanted.empty() || named) && !refused) return device;
    if (refused) software = properties.deviceName;
    found += fmt::format("{}{} ({}, {})", number ? ", " : "", number, properties.deviceName, uuid);
    ++number;
  }
  if (!wanted.empty() && !found.empty())
    throw BackendError(
        fmt::format("vulkan: there is no Vulkan device {}; the devices are {}", options.vulkan_device, found));
  if (!software.empty())
    throw BackendError(
        fmt::format("vulkan: no GPU, only the software renderer {}; check that the vendor's driver file is in "
                    "/usr/share/vulkan/icd.d or /etc/vulkan/icd.d",
                    software));
  throw BackendError(fmt::format("vulkan: no {} offers Vulkan 1.1; {}",
                                 options.allow_gpu ? "device" : "software device",
                                 options.allow_gpu ? "update the driver" : "install mesa-vulkan-drivers"));
}

VkPhysicalDeviceProperties properties_of(const Calls& vk, VkPhysicalDevice device) {
  auto all = typed<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
  vk.GetPhysicalDeviceProperties2(device, &all);
  return all.properties;
}

std::string uuid_of(const Calls& vk, VkPhysicalDevice device) {
  auto ids = typed<VkPhysicalDeviceIDProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES);
  auto all = typed<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
  all.pNext = &ids;
  vk.GetPhysicalDeviceProperties2(device, &all);
  std::string uuid;
  for (const uint8_t byte : ids.deviceUUID) uuid += fmt::format("{:02x}", byte);
  return uuid;
}

std::set<std::string> extensions_of(const Calls& vk, VkPhysicalDevice device) {
  uint32_t count = 0;
  vulkan_check(vk.EnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr), "counting extensions");
  std::vector<VkExtensionProperties> all(count);
  vulkan_check(vk.EnumerateDeviceExtensionProperties(device, nullptr, &count, all.data()), "listing extensions");
  all.resize(count);
  std::set<std::string> names;
  for (const VkExtensionProperties& extension : all) names.insert(extension.extensionName);
  return names;
}

std::string api_version_text(uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

}  // namespace spherepair
