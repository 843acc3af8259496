// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/device/device.h"

namespace spherepair {

// A CUDA device. Throws BackendError: no driver, no device, driver too old for this build, kernels not built for it.
std::unique_ptr<Device> open_cuda_device(const OpenOptions& options);

}  // namespace spherepair
