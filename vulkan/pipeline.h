// SPDX-License-Identifier: MIT
// Compute pipelines: a kernel, compiled for a group size and a variant.
#pragma once

#include <memory>
#include <vector>

#include "common/device/variant_cache.h"
#include "vulkan/device/logical_device.h"
#include "vulkan/spirv/compile.h"

namespace spherepair {

class Pipeline {
 public:
  // `folder` keeps SPIR-V, see compile_to_spirv(). Throws BackendError if glslang or the driver rejects the kernel, or
  // if it binds more buffers than the device can.
  Pipeline(const LogicalDevice& device, Kernel kernel, uint block, const Variant& variant, const std::string& folder);
  ~Pipeline();
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  VkPipeline handle() const { return pipeline_; }
  VkPipelineLayout layout() const { return layout_; }
  VkDescriptorSetLayout set_layout() const { return set_layout_; }
  const SpirvModule& module() const { return module_; }

  const std::vector<uint>& slots() const { return slots_; }  // of the storage buffers, in the order of their bindings
  bool takes(uint binding) const { return module_.bindings().contains(binding); }
  bool reads_texels() const { return texels_; }

  // Offset in bytes in the block of loose uniforms; -1: the kernel takes none.
  int steps_offset() const { return steps_offset_; }
  int view_offset() const { return view_offset_; }

 private:
  void check_bindings(const std::string& what);
  void make(const std::string& what);
  void make_layouts(const std::string& what);
  void release();

  const LogicalDevice& device_;
  SpirvModule module_;
  std::vector<uint> slots_;
  bool texels_ = false;
  int steps_offset_, view_offset_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

VkDescriptorType descriptor_type(SpirvBinding::Kind kind);

// Pipelines, each compiled on its first use.
class Pipelines {
 public:
  explicit Pipelines(const LogicalDevice& device) : device_(device) {}
  const Pipeline& get(Kernel kernel, uint block, const Variant& variant) {
    return cache_.get(kernel, block, variant, [&] {
      return std::make_unique<Pipeline>(device_, kernel, block, variant, device_.spirv_folder());
    });
  }
  uint64_t compiled() const { return cache_.compiled(); }

 private:
  const LogicalDevice& device_;
  VariantCache<Pipeline> cache_;
};

// Host seconds to compile each kernel from its text, for groups of 128 and the first variant.
std::vector<StageTime> compile_times(const LogicalDevice& device);

}  // namespace spherepair
