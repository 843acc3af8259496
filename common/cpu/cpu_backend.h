// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/backend/graphics_pipeline.h"

namespace spherepair {

// Opens the CPU backend. pipeline: OpenGL's, to draw with; without it only DrawMethod::compute draws. Throws
// std::invalid_argument for a negative number of threads.
std::unique_ptr<Backend> open_cpu_backend(const OpenOptions& options, PipelineOpener pipeline = {});

}  // namespace spherepair
