// SPDX-License-Identifier: MIT
#include "vulkan/pipeline.h"

#include <fmt/format.h>

#include <chrono>

#include "common/glsl/kernel_text.h"

namespace spherepair {
namespace {

SpirvModule module_of(const DeviceLimits& limits, Kernel kernel, uint block, const Variant& variant,
                      const std::string& what, const std::string& folder) {
  const KernelExtensions extensions{.atomics_64 = limits.atomics_64 ? "GL_EXT_shader_atomic_int64" : "",
                                    .subgroups = limits.subgroups};
  SpirvModule module = compile_to_spirv(kernel_text(kernel_name(kernel), block, variant, extensions), what, folder);
  // Mesa's lavapipe compiles a version of a kernel for each value of a uniform that controls a branch, and frees none.
  // With unrolled loops Mesa 22.3 finds wrong pairs in collide_tiled.
  limits.software ? module.read_uniforms_as_storage() : module.unroll_loops();
  module.declare(limits.floats);
  return module;
}

std::string in_words(Kernel kernel, uint block) {
  return fmt::format("{}.comp for groups of {}", kernel_name(kernel), block);
}

}  // namespace

Pipeline::Pipeline(const LogicalDevice& device, Kernel kernel, uint block, const Variant& variant,
                   const std::string& folder)
    : device_(device),
      module_(module_of(device.limits(), kernel, block, variant, in_words(kernel, block), folder)),
      steps_offset_(module_.offset_of(loose_binding, "steps_done")),
      view_offset_(module_.offset_of(loose_binding, "view_words")) {
  const std::string what = in_words(kernel, block);
  check_bindings(what);
  try {
    make(what);
  } catch (const BackendError&) {
    release();
    throw;
  }
}

Pipeline::~Pipeline() { release(); }

void Pipeline::release() {
  const Calls& vk = device_.calls();
  vk.DestroyPipeline(device_.handle(), pipeline_, nullptr);
  vk.DestroyPipelineLayout(device_.handle(), layout_, nullptr);
  vk.DestroyDescriptorSetLayout(device_.handle(), set_layout_, nullptr);
}

void Pipeline::check_bindings(const std::string& what) {
  uint textures = 0;
  for (const auto& [number, binding] : module_.bindings()) {
    if (binding.kind == SpirvBinding::Kind::texels) textures += binding.count;
    if (binding.kind == SpirvBinding::Kind::storage)
      for (uint each = 0; each < binding.count; ++each) slots_.push_back(number + each);
  }
  texels_ = textures == 1;
  if (textures > 1)
    throw BackendError(fmt::format("vulkan: {} reads several texel buffers, which no launch binds", what));
  const VkPhysicalDeviceLimits& limits = device_.limits().properties.limits;
  if (slots_.size() > std::min(limits.maxPerStageDescriptorStorageBuffers, limits.maxDescriptorSetStorageBuffers))
    throw BackendError(fmt::format(
        "vulkan: {} binds {} storage buffers, but {} binds at most {}; choose another device with "
        "--vulkan-device",
        what, slots_.size(), device_.limits().properties.deviceName, limits.maxPerStageDescriptorStorageBuffers));
}

VkDescriptorType descriptor_type(SpirvBinding::Kind kind) {
  switch (kind) {
    case SpirvBinding::Kind::storage:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case SpirvBinding::Kind::uniform:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
    case SpirvBinding::Kind::uniform_as_storage:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC;
    case SpirvBinding::Kind::texels:
      return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
  }
  return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

void Pipeline::make_layouts(const std::string& what) {
  const Calls& vk = device_.calls();
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const auto& [number, binding] : module_.bindings())
    bindings.push_back({number, descriptor_type(binding.kind), binding.count, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  auto set = typed<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  set.bindingCount = uint32_t(bindings.size());
  set.pBindings = bindings.data();
  vulkan_check(vk.CreateDescriptorSetLayout(device_.handle(), &set, nullptr, &set_layout_),
               "laying out the buffers of " + what);
  auto layout = typed<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout_;
  vulkan_check(vk.CreatePipelineLayout(device_.handle(), &layout, nullptr, &layout_),
               "laying out the pipeline of " + what);
}

void Pipeline::make(const std::string& what) {
  make_layouts(what);
  const Calls& vk = device_.calls();
  auto code = typed<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  code.codeSize = module_.words().size() * sizeof(uint32_t);
  code.pCode = module_.words().data();
  VkShaderModule shader = VK_NULL_HANDLE;
  vulkan_check(vk.CreateShaderModule(device_.handle(), &code, nullptr, &shader), "loading " + what);
  auto info = typed<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = shader;
  info.stage.pName = "main";
  info.layout = layout_;
  const VkResult result = vk.CreateComputePipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
  vk.DestroyShaderModule(device_.handle(), shader, nullptr);
  vulkan_check(result, "compiling " + what);
}

std::vector<StageTime> compile_times(const LogicalDevice& device) {
  using Clock = std::chrono::steady_clock;
  std::vector<StageTime> times;
#define KERNEL(name, reads, writes) Kernel::name,
  std::vector<Kernel> kernels = {SPHEREPAIR_MIRRORED_KERNELS(KERNEL)};
  if (device.limits().tensor_groups) kernels.insert(kernels.end(), {SPHEREPAIR_TENSOR_KERNELS(KERNEL)});
  for (const Kernel kernel : kernels) {
    const Clock::time_point start = Clock::now();
    const Pipeline compiled(
        device, kernel,
        kernel == Kernel::collide_tensor ? capabilities_of(device.limits()).tensor_block : SERVICE_BLOCK, {}, "");
    times.push_back({kernel_name(kernel), std::chrono::duration<double>(Clock::now() - start).count()});
  }
#undef KERNEL
  return times;
}

}  // namespace spherepair
