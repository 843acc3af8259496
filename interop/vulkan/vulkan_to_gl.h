// SPDX-License-Identifier: MIT
#pragma once

#include "common/backend/graphics_pipeline.h"
#include "common/device/device.h"

namespace spherepair {

// OpenGL draws the spheres of a device that open_vulkan_device opened, which must outlive the pipeline.
std::unique_ptr<GraphicsPipeline> open_vulkan_to_gl(const OpenOptions& options, Device& vulkan);

}  // namespace spherepair
