// SPDX-License-Identifier: MIT
// Turns launches into dispatches: one by one in the stream of commands, or recorded as a step's command buffer that is
// submitted again and again.
#pragma once

#include "common/device/step_recorder.h"
#include "vulkan/descriptor_sets.h"
#include "vulkan/stage_queries.h"
#include "vulkan/uniform_slices.h"

namespace spherepair {

class Launches final : public StepApi {
 public:
  Launches(const LogicalDevice& device, const BufferTable& table, CommandStream& stream, StageQueries& stages);

  // With Call::early no barrier precedes the dispatch.
  void launch_call(const Call& call) override;
  Recording record(const std::vector<Call>& calls, uint steps) override;
  void replay(const Recording& recording) override;

  void prepare(const Call& call) { pipeline_of(call); }  // compiles its kernel on the first call
  uint64_t compiled() const { return pipelines_.compiled(); }

  void make_room();       // for another launch and its timestamps; if there is none, waits for the device
  void forget_buffers();  // the device must have finished all commands that use them

 private:
  struct Dispatch;
  struct Recorded;
  // Parameters and descriptor sets of dispatches, forgotten together.
  struct Bindings {
    Bindings(const LogicalDevice& device, const BufferTable& table, uint32_t slices)
        : slices(device, slices), sets(device, table, slices_buffer()) {}
    VkBuffer slices_buffer() const { return slices.buffer(); }
    UniformSlices slices;
    DescriptorSets sets;
  };
  const Pipeline& pipeline_of(const Call& call);
  Dispatch bind(const Call& call, Bindings& bindings);
  void dispatch(VkCommandBuffer commands, const Dispatch& dispatch) const;

  const LogicalDevice& device_;
  const Calls& vk_;
  const BufferTable& table_;
  CommandStream& stream_;
  StageQueries& stages_;
  DeviceBuffer unused_;  // fills slots without a buffer
  Pipelines pipelines_;
  Bindings bindings_;
};

}  // namespace spherepair
