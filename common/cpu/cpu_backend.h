// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/backend/backend.h"

namespace spherepair {

// Throws std::invalid_argument for a negative number of threads.
std::unique_ptr<Backend> open_cpu_backend(const OpenOptions& options);

}  // namespace spherepair
