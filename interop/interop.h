// SPDX-License-Identifier: MIT
#pragma once

#include "common/backend/graphics_pipeline.h"

namespace spherepair {

// Opens OpenGL to draw the spheres of the current CUDA device. Throws BackendError if options.gl_device is another GPU,
// or if OpenGL is in software.
std::unique_ptr<GraphicsPipeline> open_cuda_to_gl(const OpenOptions& options);

}  // namespace spherepair
