// SPDX-License-Identifier: MIT
#include "vulkan/device/calls.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "common/backend/backend.h"

namespace spherepair {
namespace {

PFN_vkGetInstanceProcAddr open_loader() {
  void* library = dlopen("libvulkan.so.1", RTLD_NOW);  // stays open: drivers do not like to be loaded twice
  if (!library)
    throw BackendError(
        "vulkan: this machine has no loader libvulkan.so.1; install libvulkan1 and the GPU's driver, or "
        "mesa-vulkan-drivers for software");
  const auto found = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
  if (!found)
    throw BackendError("vulkan: libvulkan.so.1 lacks vkGetInstanceProcAddr; install the package libvulkan1 anew");
  return found;
}

PFN_vkGetInstanceProcAddr instance_function() {
  static const PFN_vkGetInstanceProcAddr function = open_loader();
  return function;
}

template <typename Function, typename Found>
void set(Function& function, Found found, const char* name) {
  if (!found) throw BackendError(fmt::format("vulkan: the driver lacks {}, a function of Vulkan 1.1; update it", name));
  function = reinterpret_cast<Function>(found);
}

const char* result_name(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "out of the host's memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "out of the device's memory";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "the driver could not be initialised";
    case VK_ERROR_MEMORY_MAP_FAILED:
      return "memory could not be mapped";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "a layer is missing";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "an extension is missing";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "a feature is missing";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "no driver";
    case VK_ERROR_TOO_MANY_OBJECTS:
      return "too many objects";
    default:
      return "another error";
  }
}

}  // namespace

void Calls::load_global() {
#define LOAD(name) set(name, instance_function()(nullptr, "vk" #name), "vk" #name);
  SPHEREPAIR_VULKAN_GLOBAL(LOAD)
#undef LOAD
}

void Calls::load_of(VkInstance instance) {
#define LOAD(name) set(name, instance_function()(instance, "vk" #name), "vk" #name);
  SPHEREPAIR_VULKAN_INSTANCE(LOAD)
#undef LOAD
#define LOAD(name) name = reinterpret_cast<PFN_vk##name>(instance_function()(instance, "vk" #name));
  SPHEREPAIR_VULKAN_OPTIONAL(LOAD)
#undef LOAD
}

void Calls::load_of(VkDevice device) {
#define LOAD(name) set(name, GetDeviceProcAddr(device, "vk" #name), "vk" #name);
  SPHEREPAIR_VULKAN_DEVICE(LOAD)
#undef LOAD
}

void vulkan_check(VkResult result, const std::string& what) {
  if (result == VK_SUCCESS) return;
  if (result == VK_ERROR_DEVICE_LOST)
    throw BackendError(
        fmt::format("vulkan: {} failed: the driver reset the device, as it does when a dispatch runs too long; use "
                    "fewer spheres or another method",
                    what));
  throw BackendError(fmt::format("vulkan: {} failed: {} (VkResult {})", what, result_name(result), int(result)));
}

}  // namespace spherepair
