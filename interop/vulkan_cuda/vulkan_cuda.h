// SPDX-License-Identifier: MIT
#pragma once

#include "common/device/device.h"
#include "common/device/device_copy.h"

namespace spherepair {

// Copies `bytes` between a device of Vulkan and one of CUDA, which must be the thread's current one, through memory
// that Vulkan exports and CUDA maps. Both must outlive the copy. Throws BackendError if they are not one GPU, or if
// Vulkan exports no memory.
DeviceCopy open_vulkan_cuda(Device& from, Device& to, uint64_t bytes);

}  // namespace spherepair
