// SPDX-License-Identifier: MIT
#pragma once

#include "common/backend/graphics_pipeline.h"
#include "common/device/device.h"

namespace spherepair {

// Opens OpenGL to draw the spheres of a device from open_vulkan_device, which must outlive the pipeline.
std::unique_ptr<GraphicsPipeline> open_vulkan_to_gl(const OpenOptions& options, Device& vulkan);

}  // namespace spherepair
