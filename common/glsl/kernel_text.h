// SPDX-License-Identifier: MIT
// Makes the text of a GLSL kernel: the same for OpenGL and Vulkan except for the names of extensions.
#pragma once

#include <string>

#include "common/device/variant.h"

namespace spherepair {

// The API's names of GLSL extensions. Kernels do without an extension whose name is empty.
struct KernelExtensions {
  std::string atomics_64;  // 64-bit atomics on buffers
  bool subgroups = false;  // GL_KHR_shader_subgroup_arithmetic and _shuffle, subgroups of 32 or more
};

// Returns the embedded shader of this name, preceded by definitions of the group size, the variant and the motion.
std::string kernel_text(const std::string& kernel, unsigned block, const Variant& variant,
                        const KernelExtensions& extensions);

}  // namespace spherepair
