// SPDX-License-Identifier: MIT
// The text of a GLSL kernel as a compiler takes it: the same for OpenGL and Vulkan but for the names of extensions.
#pragma once

#include <string>

#include "common/device/variant.h"

namespace spherepair {

// The API's names of GLSL extensions; empty: kernels do without.
struct KernelExtensions {
  std::string atomics_64;     // 64-bit atomics on buffers
  std::string float_atomics;  // of float32, for variants that need them
  bool subgroups = false;     // GL_KHR_shader_subgroup_arithmetic, with subgroups of 32 invocations or more
};

// The embedded shader of this name, with the group size, the variant and the motion defined in front of it.
std::string kernel_text(const std::string& kernel, unsigned block, const Variant& variant,
                        const KernelExtensions& extensions);

}  // namespace spherepair
