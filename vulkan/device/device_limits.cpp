// SPDX-License-Identifier: MIT
#include "vulkan/device/device_limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "vulkan/spirv/compile.h"

namespace spherepair {
namespace {

constexpr uint32_t nvidia = 0x10DE;
constexpr uint tensor_block = 256;
constexpr uint32_t shared_bytes = 32 << 10;  // of the kernel that needs most: the least that OpenGL 4.5 guarantees

// Adds a struct to a query, unless the device may not know it.
template <typename Struct>
void chain(void*& last, Struct& next, bool known) {
  if (!known) return;
  next.pNext = last;
  last = &next;
}

bool knows(const VkPhysicalDeviceProperties& properties, const std::set<std::string>& extensions, const char* name) {
  return properties.apiVersion >= VK_API_VERSION_1_2 || extensions.contains(name);
}

void require(bool there, const DeviceLimits& limits, const char* what) {
  if (there) return;
  throw BackendError(
      fmt::format("vulkan: {} lacks {}, which every kernel needs; update the driver, or choose another "
                  "device with --vulkan-device",
                  limits.properties.deviceName, what));
}

void read_features(const Calls& vk, VkPhysicalDevice device, const std::set<std::string>& extensions,
                   DeviceLimits& limits) {
  auto atomics =
      typed<VkPhysicalDeviceShaderAtomicInt64Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_ATOMIC_INT64_FEATURES);
  auto all = typed<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
  chain(all.pNext, atomics, knows(limits.properties, extensions, VK_KHR_SHADER_ATOMIC_INT64_EXTENSION_NAME));
  vk.GetPhysicalDeviceFeatures2(device, &all);
  require(all.features.shaderInt64, limits, "64-bit integers (shaderInt64)");
  require(all.features.shaderFloat64, limits, "float64 (shaderFloat64)");
  limits.atomics_64 = atomics.shaderBufferInt64Atomics;
  limits.exports_memory = !limits.software && extensions.contains(VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME);
  limits.memory_budget = extensions.contains(VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
}

// Whether a subgroup can multiply matrices of 16 x 16 halves into float32 sums.
bool multiplies_halves(const Calls& vk, VkPhysicalDevice device) {
  uint32_t count = 0;
  vk.GetPhysicalDeviceCooperativeMatrixPropertiesNV(device, &count, nullptr);
  std::vector<VkCooperativeMatrixPropertiesNV> shapes(
      count, typed<VkCooperativeMatrixPropertiesNV>(VK_STRUCTURE_TYPE_COOPERATIVE_MATRIX_PROPERTIES_NV));
  vk.GetPhysicalDeviceCooperativeMatrixPropertiesNV(device, &count, shapes.data());
  return std::ranges::any_of(shapes, [](const VkCooperativeMatrixPropertiesNV& shape) {
    return shape.MSize == 16 && shape.NSize == 16 && shape.KSize == 16 && shape.scope == VK_SCOPE_SUBGROUP_NV &&
           shape.AType == VK_COMPONENT_TYPE_FLOAT16_NV && shape.BType == VK_COMPONENT_TYPE_FLOAT16_NV &&
           shape.CType == VK_COMPONENT_TYPE_FLOAT32_NV && shape.DType == VK_COMPONENT_TYPE_FLOAT32_NV;
  });
}

// How many groups of collide_tensor run at once: two on each multiprocessor. 0: the device lacks what it needs.
uint32_t tensor_groups(const Calls& vk, VkPhysicalDevice device, const std::set<std::string>& extensions) {
  const auto lacks = [&](const char* name) { return !extensions.contains(name); };
  if (lacks(VK_NV_COOPERATIVE_MATRIX_EXTENSION_NAME) || lacks(VK_NV_SHADER_SM_BUILTINS_EXTENSION_NAME)) return 0;
  auto halves =
      typed<VkPhysicalDeviceShaderFloat16Int8Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_FLOAT16_INT8_FEATURES);
  auto model =
      typed<VkPhysicalDeviceVulkanMemoryModelFeatures>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_MEMORY_MODEL_FEATURES);
  auto features = typed<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
  chain(features.pNext, halves, true);
  chain(features.pNext, model, true);
  vk.GetPhysicalDeviceFeatures2(device, &features);
  if (!halves.shaderFloat16 || !model.vulkanMemoryModel || !multiplies_halves(vk, device)) return 0;
  auto processors = typed<VkPhysicalDeviceShaderSMBuiltinsPropertiesNV>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_SM_BUILTINS_PROPERTIES_NV);
  auto properties = typed<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
  properties.pNext = &processors;
  vk.GetPhysicalDeviceProperties2(device, &properties);
  return 2 * processors.shaderSMCount;
}

FloatControls float_controls(const VkPhysicalDeviceFloatControlsProperties& said) {
  const auto by_width = [](VkShaderFloatControlsIndependence independence) {
    return independence != VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_NONE;
  };
  return {.of_32 = {bool(said.shaderRoundingModeRTEFloat32), bool(said.shaderDenormPreserveFloat32),
                    bool(said.shaderSignedZeroInfNanPreserveFloat32)},
          .of_64 = {bool(said.shaderRoundingModeRTEFloat64), bool(said.shaderDenormPreserveFloat64),
                    bool(said.shaderSignedZeroInfNanPreserveFloat64)},
          .rounding_by_width = by_width(said.roundingModeIndependence),
          .denormals_by_width = by_width(said.denormBehaviorIndependence)};
}

// Whether subgroups are as group_sum.glsl assumes: 32 or more invocations, which are consecutive. No query tells
// whether they are: NVIDIA's are; other GPUs use shared memory.
bool has_subgroups(const VkPhysicalDeviceSubgroupProperties& said, const VkPhysicalDeviceProperties& properties) {
  return properties.vendorID == nvidia && said.subgroupSize >= 32 &&
         (said.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) &&
         (said.supportedOperations & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT) &&
         (said.supportedOperations & VK_SUBGROUP_FEATURE_SHUFFLE_BIT);
}

void read_properties(const Calls& vk, VkPhysicalDevice device, const std::set<std::string>& extensions,
                     DeviceLimits& limits) {
  auto subgroups = typed<VkPhysicalDeviceSubgroupProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES);
  auto allocation =
      typed<VkPhysicalDeviceMaintenance3Properties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES);
  auto driver = typed<VkPhysicalDeviceDriverProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
  auto floats =
      typed<VkPhysicalDeviceFloatControlsProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES);
  auto all = typed<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
  chain(all.pNext, subgroups, true);
  chain(all.pNext, allocation, true);
  chain(all.pNext, driver, knows(limits.properties, extensions, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME));
  chain(all.pNext, floats, knows(limits.properties, extensions, VK_KHR_SHADER_FLOAT_CONTROLS_EXTENSION_NAME));
  vk.GetPhysicalDeviceProperties2(device, &all);
  limits.subgroups = has_subgroups(subgroups, limits.properties);
  limits.largest_binding =
      std::min<uint64_t>(limits.properties.limits.maxStorageBufferRange, allocation.maxMemoryAllocationSize);
  limits.driver = driver.driverName[0] ? fmt::format("{} {}", driver.driverName, driver.driverInfo)
                                       : fmt::format("version {}", limits.properties.driverVersion);
  limits.floats = float_controls(floats);
}

// The first family that computes: NVIDIA's is its fastest for short dispatches. It copies, too.
void find_queue(const Calls& vk, VkPhysicalDevice device, DeviceLimits& limits) {
  uint32_t count = 0;
  vk.GetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk.GetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  families.resize(count);
  const auto found = std::ranges::find_if(families, [](const VkQueueFamilyProperties& family) {
    return (family.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0 && family.queueCount > 0;
  });
  require(found != families.end(), limits, "a queue that computes");
  limits.queue_family = uint32_t(found - families.begin());
  limits.timestamp_bits = found->timestampValidBits;
}

void require_groups(const DeviceLimits& limits) {
  const VkPhysicalDeviceLimits& said = limits.properties.limits;
  require(said.maxComputeWorkGroupInvocations >= SPLIT_BLOCK && said.maxComputeWorkGroupSize[0] >= SPLIT_BLOCK, limits,
          "groups of 1024 invocations");
  require(said.maxComputeSharedMemorySize >= shared_bytes, limits, "32 KiB of shared memory a group");
  require(said.maxComputeWorkGroupCount[0] >= MAX_GROUPS && said.maxComputeWorkGroupCount[1] >= MAX_GROUPS, limits,
          "dispatches of 65535 groups along two axes");
}

std::string modes_in_words(const FloatModes& modes) {
  std::string text;
  const auto add = [&](bool there, const char* what) {
    if (there) text += (text.empty() ? "" : ", ") + std::string(what);
  };
  add(modes.round_to_even, "rounding to nearest even");
  add(modes.keep_denormals, "denormals");
  add(modes.keep_signed_zeros, "signed zeros, infinities and NaN");
  return text.empty() ? "none: as the driver has them" : text;
}

}  // namespace

DeviceLimits device_limits(const Calls& vk, VkPhysicalDevice device, const OpenOptions& options) {
  DeviceLimits limits;
  limits.properties = properties_of(vk, device);
  limits.software = in_software(limits.properties);
  limits.uuid = uuid_of(vk, device);
  const std::set<std::string> extensions = extensions_of(vk, device);
  read_features(vk, device, extensions, limits);
  read_properties(vk, device, extensions, limits);
  find_queue(vk, device, limits);
  require_groups(limits);
  if (limits.subgroups) limits.tensor_groups = tensor_groups(vk, device, extensions);
  limits.subgroups &= options.subgroups;
  limits.largest_texture = std::min<uint64_t>(limits.properties.limits.maxTexelBufferElements, options.texels);
  return limits;
}

WantedFeatures::WantedFeatures(const DeviceLimits& limits) {
  const bool core = limits.properties.apiVersion >= VK_API_VERSION_1_2;
  const FloatModes &of_32 = limits.floats.of_32, &of_64 = limits.floats.of_64;
  const bool floats = of_32.round_to_even || of_32.keep_denormals || of_32.keep_signed_zeros || of_64.round_to_even ||
                      of_64.keep_denormals || of_64.keep_signed_zeros;
  if (limits.exports_memory) extensions.push_back(VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME);
  if (limits.tensor_groups) extensions.push_back(VK_NV_COOPERATIVE_MATRIX_EXTENSION_NAME);
  matrices_.cooperativeMatrix = memory_model_.vulkanMemoryModel = halves_.shaderFloat16 = VK_TRUE;
  features.features.shaderInt64 = features.features.shaderFloat64 = VK_TRUE;
  if (floats && !core) extensions.push_back(VK_KHR_SHADER_FLOAT_CONTROLS_EXTENSION_NAME);
  if (limits.atomics_64 && !core) extensions.push_back(VK_KHR_SHADER_ATOMIC_INT64_EXTENSION_NAME);
  atomics_64_.shaderBufferInt64Atomics = VK_TRUE;
  chain(features.pNext, atomics_64_, limits.atomics_64);
  chain(features.pNext, matrices_, limits.tensor_groups != 0);
  chain(features.pNext, memory_model_, limits.tensor_groups != 0);
  chain(features.pNext, halves_, limits.tensor_groups != 0);
}

BackendInfo describe_device(const DeviceLimits& limits) {
  BackendInfo info;
  info.name = "vulkan";
  info.language = "GLSL";
  info.device = limits.properties.deviceName;
  info.software = limits.software;
  info.device_timers = !limits.software && limits.timestamp_bits != 0;
  if (!limits.software) info.uuid = limits.uuid;
  info.details = {{"driver", limits.driver},
                  {"glslang", glslang_version()},
                  {"Vulkan version", api_version_text(limits.properties.apiVersion)},
                  {"largest storage buffer bytes", std::to_string(limits.largest_binding)},
                  {"largest texel buffer elements", std::to_string(limits.largest_texture)},
                  {"shared memory bytes", std::to_string(limits.properties.limits.maxComputeSharedMemorySize)},
                  {"64-bit atomics", limits.atomics_64 ? "yes" : "no: drawing takes two passes"},
                  {"subgroups", limits.subgroups ? "yes" : "no: sums go through shared memory"},
                  {"tensor cores", limits.tensor_groups ? "yes" : "no: collide_tensor is left out"},
                  {"float32 keeps", modes_in_words(limits.floats.of_32)},
                  {"float64 keeps", modes_in_words(limits.floats.of_64)}};
  return info;
}

DeviceCapabilities capabilities_of(const DeviceLimits& limits) {
  return {.largest_buffer = limits.largest_binding,
          .atomics_64 = limits.atomics_64,
          .overlaps_images = true,
          .makes_lists = !limits.software,
          .bounds_block = 256,  // as in OpenGL
          .tensor_groups = limits.tensor_groups,
          .tensor_block = tensor_block};
}

}  // namespace spherepair
