// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/device/device.h"

namespace spherepair {

// A CUDA device. Throws BackendError: no driver, no device, driver too old for this build, kernels not built for it.
std::unique_ptr<Device> open_cuda_device(const OpenOptions& options);

// The memory of a buffer of the device that open_cuda_device opened; BackendError for another one. Valid until the
// next upload.
void* cuda_memory(Device& device, uint slot);

}  // namespace spherepair
