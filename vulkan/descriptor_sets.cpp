// SPDX-License-Identifier: MIT
#include "vulkan/descriptor_sets.h"

#include <algorithm>

#include "vulkan/uniform_slices.h"

namespace spherepair {
namespace {

constexpr uint32_t sets_of_pool = 128;

bool pool_is_full(VkResult result) {
  return result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
}

}  // namespace

// The descriptors of a set; the writes point to the other members.
struct DescriptorSets::Contents {
  std::vector<VkDescriptorBufferInfo> storage;  // in the order of the pipeline's slots
  VkDescriptorBufferInfo uniform;
  VkBufferView view;

  std::vector<VkWriteDescriptorSet> writes(const Pipeline& pipeline, VkDescriptorSet set) const {
    std::vector<VkWriteDescriptorSet> all;
    const VkDescriptorBufferInfo* next = storage.data();
    for (const auto& [number, binding] : pipeline.module().bindings()) {
      auto write = typed<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
      write.dstSet = set;
      write.dstBinding = number;
      write.descriptorCount = binding.count;
      write.descriptorType = descriptor_type(binding.kind);
      switch (binding.kind) {
        case SpirvBinding::Kind::storage:
          write.pBufferInfo = next, next += binding.count;
          break;
        case SpirvBinding::Kind::uniform:
        case SpirvBinding::Kind::uniform_as_storage:
          write.pBufferInfo = &uniform;
          break;
        case SpirvBinding::Kind::texels:
          write.pTexelBufferView = &view;
          break;
      }
      all.push_back(write);
    }
    return all;
  }
};

VkDescriptorSet DescriptorSets::get(const Pipeline& pipeline, const BufferHandles& buffers, const Texels& texels,
                                    VkBuffer unused) {
  const std::vector<uint>& slots = pipeline.slots();
  std::vector<Set>& sets = sets_[&pipeline];
  for (const Set& set : sets)
    if (set.texels == texels &&
        std::ranges::equal(set.buffers, slots, {}, {}, [&](uint slot) { return buffers[slot]; }))
      return set.handle;
  Set set{{}, texels, allocate(pipeline)};
  Contents contents{{}, {uniforms_, 0, UniformSlices::slice_bytes}, pipeline.reads_texels() ? view(texels) : nullptr};
  for (const uint slot : slots) {
    set.buffers.push_back(buffers[slot]);
    contents.storage.push_back({buffers[slot] ? table_.at(buffers[slot]) : unused, 0, VK_WHOLE_SIZE});
  }
  const std::vector<VkWriteDescriptorSet> writes = contents.writes(pipeline, set.handle);
  device_.calls().UpdateDescriptorSets(device_.handle(), uint32_t(writes.size()), writes.data(), 0, nullptr);
  sets.push_back(set);
  ++made_;
  return set.handle;
}

void DescriptorSets::add_pool() {
  const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 16 * sets_of_pool},
                                        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, 2 * sets_of_pool},
                                        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC, 2 * sets_of_pool},
                                        {VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, sets_of_pool}};
  auto info = typed<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  info.maxSets = sets_of_pool;
  info.poolSizeCount = uint32_t(std::size(sizes));
  info.pPoolSizes = sizes;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  vulkan_check(device_.calls().CreateDescriptorPool(device_.handle(), &info, nullptr, &pool),
               "making a pool of descriptor sets");
  pools_.push_back(pool);
}

VkDescriptorSet DescriptorSets::allocate(const Pipeline& pipeline) {
  if (pools_.empty()) add_pool();
  const VkDescriptorSetLayout layout = pipeline.set_layout();
  auto info = typed<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  const auto attempt = [&] {
    info.descriptorPool = pools_.back();
    return device_.calls().AllocateDescriptorSets(device_.handle(), &info, &set);
  };
  VkResult result = attempt();
  if (pool_is_full(result)) add_pool(), result = attempt();
  vulkan_check(result, "making a descriptor set");
  return set;
}

VkBufferView DescriptorSets::view(const Texels& texels) {
  VkBufferView& view = views_[texels];
  if (view) return view;
  auto info = typed<VkBufferViewCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO);
  info.buffer = table_.at(texels.buffer);
  info.format = texels.format;
  info.range = texels.bytes;
  vulkan_check(device_.calls().CreateBufferView(device_.handle(), &info, nullptr, &view), "making a texel buffer");
  return view;
}

void DescriptorSets::forget() {
  const Calls& vk = device_.calls();
  for (const auto& [texels, view] : views_) vk.DestroyBufferView(device_.handle(), view, nullptr);
  for (VkDescriptorPool pool : pools_) vk.DestroyDescriptorPool(device_.handle(), pool, nullptr);
  views_.clear(), pools_.clear(), sets_.clear();
  made_ = 0;
}

}  // namespace spherepair
