// SPDX-License-Identifier: MIT
#pragma once

#include "common/backend/graphics_pipeline.h"

namespace spherepair {

// OpenGL draws the spheres of the current CUDA device. options.gl_device names the same GPU. Throws BackendError where
// OpenGL is on another one, or in software.
std::unique_ptr<GraphicsPipeline> open_cuda_to_gl(const OpenOptions& options);

}  // namespace spherepair
