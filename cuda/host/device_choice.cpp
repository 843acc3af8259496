// SPDX-License-Identifier: MIT
#include "cuda/host/device_choice.h"

#include <fmt/format.h>

#include "cuda/host/check.h"

namespace spherepair {

std::string version_text(int number) { return fmt::format("{}.{}", number / 1000, number % 1000 / 10); }

int use_device(int wanted) {
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
  if (wanted < 0 || wanted >= count) {
    throw BackendError(fmt::format("cuda: there is no device {}; devices are 0 to {}", wanted, count - 1));
  }
  cuda_check(cudaSetDevice(wanted), fmt::format("choosing device {}", wanted));
  return wanted;
}

BackendInfo describe_device(int device) {
  BackendInfo info;
  cudaDeviceProp properties;
  cuda_check(cudaGetDeviceProperties(&properties, device), "reading the device's properties");
  int driver = 0, runtime = 0, clock_khz = 0;
  cudaDriverGetVersion(&driver);
  cudaRuntimeGetVersion(&runtime);
  cudaDeviceGetAttribute(&clock_khz, cudaDevAttrClockRate, device);
  info.name = "cuda";
  info.interop = true;
  info.device = properties.name;
  for (const char byte : properties.uuid.bytes) info.uuid += fmt::format("{:02x}", uint(uint8_t(byte)));
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

}  // namespace spherepair
