// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/backend/backend.h"

namespace spherepair {

// Throws BackendError: no EGL device, GL below 4.5, a missing extension, software where hardware is required.
std::unique_ptr<Backend> open_glsl_backend(const OpenOptions& options);

}  // namespace spherepair
