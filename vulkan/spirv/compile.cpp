// SPDX-License-Identifier: MIT
#include "vulkan/spirv/compile.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "common/backend/backend.h"

namespace spherepair {
namespace {

constexpr int glsl_version = 450;
constexpr EShMessages messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);

void set_target(glslang::TShader& shader) {
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
}

void set_bindings(glslang::TShader& shader) {
  shader.setShiftBinding(glslang::EResUbo, params_binding - SLOT_PARAMS);
  shader.setShiftBinding(glslang::EResTexture, first_texture_binding);
  shader.setEnvInputVulkanRulesRelaxed();  // gathers loose uniforms
  shader.setGlobalUniformBlockName("Loose");
  shader.setGlobalUniformSet(0);
  shader.setGlobalUniformBinding(loose_binding - params_binding);  // before the shift
}

}  // namespace

SpirvModule compile_to_spirv(const std::string& text, const std::string& what) {
  [[maybe_unused]] static const bool ready = glslang::InitializeProcess();
  glslang::TShader shader(EShLangCompute);
  const char* source = text.c_str();
  shader.setStrings(&source, 1);
  set_target(shader);
  set_bindings(shader);
  const bool parsed = shader.parse(GetDefaultResources(), glsl_version, false, messages);
  glslang::TProgram program;
  program.addShader(&shader);
  if (!parsed || !program.link(messages) || !program.mapIO())
    throw BackendError(
        fmt::format("vulkan: glslang rejected {}; use the version of glslang that this project names:\n{}{}", what,
                    shader.getInfoLog(), program.getInfoLog()));
  std::vector<uint32_t> words;
  glslang::SpvOptions options;
  options.disableOptimizer = true;  // drivers optimise
  glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), words, &options);
  return SpirvModule(std::move(words));
}

}  // namespace spherepair
