// SPDX-License-Identifier: MIT
#include "cuda/host/device_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/shared/tensor_form.h"
#include "cuda/host/check.h"
#include "cuda/host/entries.h"

namespace spherepair {

namespace {

cudaDeviceProp properties_of(int device) {
  cudaDeviceProp properties;
  cuda_check(cudaGetDeviceProperties(&properties, device), "reading the device's properties");
  return properties;
}

std::string uuid_of(const cudaDeviceProp& properties) {
  std::string uuid;
  for (const char byte : properties.uuid.bytes) uuid += fmt::format("{:02x}", uint(uint8_t(byte)));
  return uuid;
}

int attribute_of(int device, cudaDeviceAttr attribute) {
  int value = 0;
  cuda_check(cudaDeviceGetAttribute(&value, attribute, device), "reading an attribute of the device");
  return value;
}

int device_number(const DeviceName& wanted, int count) {
  if (wanted.empty()) return 0;
  if (wanted.number && *wanted.number < uint(count)) return int(*wanted.number);
  std::string found;
  for (int device = 0; device < count; ++device) {
    const std::string uuid = uuid_of(properties_of(device));
    if (uuid == wanted.uuid) return device;
    found += fmt::format("{}{} ({})", device ? ", " : "", device, uuid);
  }
  const std::string missing = wanted.number ? std::to_string(*wanted.number) : wanted.uuid;
  throw BackendError(fmt::format("cuda: there is no CUDA device {}; the devices are {}", missing, found));
}

}  // namespace

std::string version_text(int number) { return fmt::format("{}.{}", number / 1000, number % 1000 / 10); }

int use_device(const DeviceName& wanted) {
  int count = 0;
  const cudaError_t error = cudaGetDeviceCount(&count);
  if (error == cudaErrorInsufficientDriver) {
    int driver = 0, runtime = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&runtime);
    if (driver == 0)
      throw BackendError("cuda: no NVIDIA driver on this machine; install one or leave this backend out");
    throw BackendError(
        fmt::format("cuda: the driver supports CUDA {}, but this build needs {}; update the driver or build "
                    "with an older toolkit",
                    version_text(driver), version_text(runtime)));
  }
  if (error == cudaErrorNoDevice || (error == cudaSuccess && count == 0)) {
    throw BackendError("cuda: the driver finds no device; check nvidia-smi and CUDA_VISIBLE_DEVICES");
  }
  cuda_check(error, "counting devices");
  const int device = device_number(wanted, count);
  cuda_check(cudaSetDevice(device), fmt::format("choosing device {}", device));
  return device;
}

BackendInfo describe_device(int device) {
  BackendInfo info;
  const cudaDeviceProp properties = properties_of(device);
  int driver = 0, runtime = 0, clock_khz = 0;
  cudaDriverGetVersion(&driver);
  cudaRuntimeGetVersion(&runtime);
  cudaDeviceGetAttribute(&clock_khz, cudaDevAttrClockRate, device);
  info.name = "cuda";
  info.language = "CUDA C++";
  info.device = properties.name;
  info.uuid = uuid_of(properties);
  info.device_timers = true;
  info.details = {{"compute capability", fmt::format("{}.{}", properties.major, properties.minor)},
                  {"driver supports CUDA", version_text(driver)},
                  {"CUDA runtime", version_text(runtime)},
                  {"multiprocessors", std::to_string(properties.multiProcessorCount)},
                  {"highest clock MHz", std::to_string(clock_khz / 1000)},
                  {"memory bytes", std::to_string(properties.totalGlobalMem)},
                  {"L2 bytes", std::to_string(properties.l2CacheSize)},
                  {"L2 bytes to set aside", std::to_string(properties.persistingL2CacheMaxSize)}};
  return info;
}

uint tensor_groups(int device) {
  cudaFuncAttributes attributes;
  const bool loaded = cudaFuncGetAttributes(&attributes, collide_tensor_kernel(TENSOR_BLOCK, {})) == cudaSuccess;
  cudaGetLastError();  // drops the error
  return loaded ? uint(attribute_of(device, cudaDevAttrMultiProcessorCount)) : 0;
}

uint persistent_groups(int device) {
  uint each = ~0u;  // groups a multiprocessor, for both variants
  for (const bool equal_radii : {false, true}) {
    int groups = 0;
    const Entry entry = persistent_steps_kernel(SERVICE_BLOCK, {.equal_radii = equal_radii});
    if (cudaOccupancyMaxActiveBlocksPerMultiprocessor(&groups, entry, SERVICE_BLOCK, 0) != cudaSuccess) groups = 0;
    each = std::min(each, uint(groups));
  }
  cudaGetLastError();  // drops the error
  return attribute_of(device, cudaDevAttrCooperativeLaunch)
             ? each * uint(attribute_of(device, cudaDevAttrMultiProcessorCount))
             : 0;
}

}  // namespace spherepair
