// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "backend.h"

namespace spherepair {

// Throws BackendError: no driver, no device, driver too old for this build, kernels not built for the device.
std::unique_ptr<Backend> open_cuda_backend(const OpenOptions& options);

}  // namespace spherepair
