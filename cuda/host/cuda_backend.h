// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/backend/backend.h"

namespace spherepair {

// Throws BackendError: no driver, no device, driver too old for this build, kernels not built for the device.
std::unique_ptr<Backend> open_cuda_backend(const OpenOptions& options);

// Device memory of a backend that open_cuda_backend opened; BackendError for another, or without a scene.
struct DeviceMemoryView {
  void* data;
  uint64_t bytes;
};
DeviceMemoryView cuda_positions(Backend& backend);  // vec4[n]
DeviceMemoryView cuda_contacts(Backend& backend);   // uint[n], by the number of the sphere, of the last collide()

}  // namespace spherepair
