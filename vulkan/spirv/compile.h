// SPDX-License-Identifier: MIT
// Compiles GLSL text, the same that OpenGL compiles, to SPIR-V by glslang in this process. Bindings differ from
// OpenGL's: Vulkan has one numbering for all kinds of bindings, and no uniforms outside of blocks.
#pragma once

#include <filesystem>
#include <string>

#include "common/shared/layout.h"
#include "vulkan/spirv/module.h"

namespace spherepair {

// Bindings in the one descriptor set of a kernel. A storage buffer has the number of its slot; three slots that kernels
// see as one array are one binding with three descriptors.
constexpr uint params_binding = SLOT_TOTAL + SLOT_PARAMS;
constexpr uint loose_binding = params_binding + 1;  // the block in which glslang gathers uniforms outside of blocks
constexpr uint first_texture_binding = loose_binding + 1;

// Compiles a compute shader for Vulkan 1.1. Throws BackendError with glslang's messages; `what` names the kernel.
// Keeps the result in a file of `folder`, unless that is empty: glslang takes 0.15 s to start, 0.01 s for a kernel.
SpirvModule compile_to_spirv(const std::string& text, const std::string& what,
                             const std::filesystem::path& folder = {});

// The same for OpenGL 4.5, as words, with OpenGL's own bindings: see OpenOptions::to_spirv.
std::vector<uint32_t> compile_for_opengl(const std::string& text, const std::string& what);

// The version of glslang in this process. With the text it decides what SPIR-V is made.
std::string glslang_version();

}  // namespace spherepair
