// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/device/device.h"

namespace spherepair {

// Opens the OpenGL device. Throws BackendError without an EGL device, with GL below 4.5, without a needed extension, or
// in software if hardware is required.
std::unique_ptr<Device> open_gl_device(const OpenOptions& options);

}  // namespace spherepair
