// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/device/device.h"

namespace spherepair {

// The Vulkan device that options.vulkan_device names, else the first. Throws BackendError: no loader, no driver, no
// device with what kernels need, software where hardware is required.
std::unique_ptr<Device> open_vulkan_device(const OpenOptions& options);

}  // namespace spherepair
