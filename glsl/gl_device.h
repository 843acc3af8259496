// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/device/device.h"

namespace spherepair {

// The OpenGL device. Throws BackendError: no EGL device, GL below 4.5, a missing extension, software where hardware is
// required.
std::unique_ptr<Device> open_gl_device(const OpenOptions& options);

}  // namespace spherepair
