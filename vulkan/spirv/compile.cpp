// SPDX-License-Identifier: MIT
#include "vulkan/spirv/compile.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "common/backend/backend.h"
#include "vulkan/spirv/module_files.h"

namespace spherepair {
namespace {

constexpr int glsl_version = 450;

constexpr const char* vulkan_rules = "Vulkan 1.1, SPIR-V 1.3, relaxed";  // names all of set_vulkan() in keys of files
void set_vulkan(glslang::TShader& shader) {
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  shader.setShiftBinding(glslang::EResUbo, params_binding - SLOT_PARAMS);
  shader.setShiftBinding(glslang::EResTexture, first_texture_binding);
  shader.setEnvInputVulkanRulesRelaxed();  // gathers loose uniforms
  shader.setGlobalUniformBlockName("Loose");
  shader.setGlobalUniformSet(0);
  shader.setGlobalUniformBinding(loose_binding - params_binding);  // before the shift
}

void set_opengl(glslang::TShader& shader) {
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientOpenGL, 100);
  shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
}

std::vector<uint32_t> compiled(glslang::TShader& shader, const std::string& text, EShMessages rules,
                               const std::string& what) {
  const char* source = text.c_str();
  const auto messages = EShMessages(EShMsgSpvRules | rules);
  shader.setStrings(&source, 1);
  const bool parsed = shader.parse(GetDefaultResources(), glsl_version, false, messages);
  glslang::TProgram program;
  program.addShader(&shader);
  if (!parsed || !program.link(messages) || !program.mapIO())
    throw BackendError(fmt::format("{}: glslang rejected {}; use the version of glslang that this project names:\n{}{}",
                                   rules == EShMsgVulkanRules ? "vulkan" : "opengl-spirv", what, shader.getInfoLog(),
                                   program.getInfoLog()));
  std::vector<uint32_t> words;
  glslang::SpvOptions options;
  options.disableOptimizer = true;  // drivers optimise
  glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), words, &options);
  return words;
}

void start_glslang() { [[maybe_unused]] static const bool ready = glslang::InitializeProcess(); }

}  // namespace

SpirvModule compile_to_spirv(const std::string& text, const std::string& what, const std::filesystem::path& folder) {
  const std::string key = fmt::format("{}, glslang {}, {} {} {}\n{}", vulkan_rules, glslang_version(), params_binding,
                                      loose_binding, first_texture_binding, text);
  return SpirvModule(kept_words(folder, key, [&] {
    start_glslang();
    glslang::TShader shader(EShLangCompute);
    set_vulkan(shader);
    return compiled(shader, text, EShMsgVulkanRules, what);
  }));
}

std::vector<uint32_t> compile_for_opengl(const std::string& text, const std::string& what) {
  start_glslang();
  glslang::TShader shader(EShLangCompute);
  set_opengl(shader);
  return compiled(shader, text, EShMsgDefault, what);
}

std::string glslang_version() {
  const glslang::Version version = glslang::GetVersion();
  return fmt::format("{}.{}.{}{}", version.major, version.minor, version.patch, version.flavor);
}

}  // namespace spherepair
