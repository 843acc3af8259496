// SPDX-License-Identifier: MIT
// GLSL text to SPIR-V by glslang, in this process: the text that OpenGL compiles, too. What the two APIs bind in
// another way is arranged here: Vulkan has one numbering for all kinds of bindings, and no uniforms outside of blocks.
#pragma once

#include <string>

#include "common/shared/layout.h"
#include "vulkan/spirv/module.h"

namespace spherepair {

// Bindings in the one descriptor set of a kernel. Storage buffers have their slots; three slots that kernels see as one
// array are one binding with three descriptors.
constexpr uint params_binding = SLOT_TOTAL + SLOT_PARAMS;
constexpr uint loose_binding = params_binding + 1;  // the block in which glslang gathers uniforms outside of blocks
constexpr uint first_texture_binding = loose_binding + 1;

// The module of a compute shader for Vulkan 1.1. Throws BackendError with glslang's messages; `what` names the kernel.
SpirvModule compile_to_spirv(const std::string& text, const std::string& what);

}  // namespace spherepair
