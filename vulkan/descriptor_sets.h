// SPDX-License-Identifier: MIT
// Descriptor sets: the buffers that a dispatch of a pipeline sees. Each set is made once.
#pragma once

#include <map>

#include "vulkan/device/device_buffer.h"
#include "vulkan/pipeline.h"

namespace spherepair {

// A buffer whose elements are read as texels.
struct Texels {
  uint64_t buffer = 0;  // its handle
  uint64_t bytes = 0;
  VkFormat format = VK_FORMAT_UNDEFINED;
  auto operator<=>(const Texels&) const = default;
};

class DescriptorSets {
 public:
  // uniforms: the buffer that the dynamic offsets of a dispatch refer to.
  DescriptorSets(const LogicalDevice& device, const BufferTable& table, VkBuffer uniforms)
      : device_(device), table_(table), uniforms_(uniforms) {}
  ~DescriptorSets() { forget(); }
  DescriptorSets(const DescriptorSets&) = delete;
  DescriptorSets& operator=(const DescriptorSets&) = delete;

  // Finds or makes the set. `unused` fills slots without a buffer: kernels declare buffers that some launches do not
  // use.
  VkDescriptorSet get(const Pipeline& pipeline, const BufferHandles& buffers, const Texels& texels, VkBuffer unused);

  size_t made() const { return made_; }
  void forget();  // forgets all sets; the device must have finished all commands that use them

 private:
  struct Set {
    std::vector<uint64_t> buffers;  // handles, in the order of the pipeline's slots
    Texels texels;
    VkDescriptorSet handle;
  };
  struct Contents;
  VkDescriptorSet allocate(const Pipeline& pipeline);
  VkBufferView view(const Texels& texels);
  void add_pool();

  const LogicalDevice& device_;
  const BufferTable& table_;
  VkBuffer uniforms_;
  std::map<const Pipeline*, std::vector<Set>> sets_;
  std::map<Texels, VkBufferView> views_;
  std::vector<VkDescriptorPool> pools_;
  size_t made_ = 0;
};

}  // namespace spherepair
