// SPDX-License-Identifier: MIT
#include "vulkan/launches.h"

#include <algorithm>
#include <cstring>

namespace spherepair {
namespace {

constexpr uint32_t slices_of_stream = 8192;
constexpr uint32_t slices_of_launch = 2;  // the parameters, and the loose uniforms
constexpr size_t most_sets = 2048;
constexpr uint64_t unused_bytes = 256;
static_assert(sizeof(Params) <= UniformSlices::slice_bytes && sizeof(View) <= UniformSlices::slice_bytes);

Texels texels_of(const Call& call) {
  if (call.launch.kernel == Kernel::draw_cull)
    return {call.buffers[SLOT_PYRAMID], call.launch.texels * sizeof(uvec2), VK_FORMAT_R32G32_UINT};
  return {call.buffers[SLOT_CELL], call.launch.texels * sizeof(uint), VK_FORMAT_R32_UINT};
}

// The number of steps done is a loose uniform: in the block it would make a new slice for every step.
uint32_t params_offset(const Call& call, UniformSlices& slices) {
  Params params = call.params;
  params.motion.steps_done = 0;
  return slices.offset_of(&params, sizeof params);
}

uint32_t loose_offset(const Call& call, const Pipeline& pipeline, UniformSlices& slices) {
  std::array<char, UniformSlices::slice_bytes> block{};
  const auto put = [&](int offset, const void* data, size_t bytes) {
    if (offset >= 0) std::memcpy(block.data() + offset, data, std::min(bytes, block.size() - size_t(offset)));
  };
  put(pipeline.view_offset(), &call.view, sizeof call.view);
  put(pipeline.steps_offset(), &call.params.motion.steps_done, sizeof call.params.motion.steps_done);
  return slices.offset_of(block.data(), block.size());
}

}  // namespace

// A launch, ready to be recorded.
struct Launches::Dispatch {
  const Pipeline* pipeline;
  VkDescriptorSet set;
  std::array<uint32_t, slices_of_launch> offsets{};  // in the order of the bindings
  uint32_t offset_count = 0;
  std::array<uint, 3> groups;
  bool early;
};

struct Launches::Recorded {
  Recorded(Launches& launches, uint32_t slices)
      : stream(launches.stream_), bindings(launches.device_, launches.table_, slices), commands(stream.make()) {}
  ~Recorded() {
    try {
      stream.wait(number);
    } catch (const BackendError&) {  // the device has failed, and an earlier call has said so
    }
    stream.free(commands);
  }
  Recorded(const Recorded&) = delete;
  Recorded& operator=(const Recorded&) = delete;

  CommandStream& stream;
  Bindings bindings;
  VkCommandBuffer commands;
  uint dispatches = 0;
  uint64_t number = 0;  // of the last submission that replays it
};

Launches::Launches(const LogicalDevice& device, const BufferTable& table, CommandStream& stream, StageQueries& stages)
    : device_(device),
      vk_(device.calls()),
      table_(table),
      stream_(stream),
      stages_(stages),
      unused_(device, unused_bytes, Place::device),
      pipelines_(device),
      bindings_(device, table, slices_of_stream) {}

const Pipeline& Launches::pipeline_of(const Call& call) {
  return pipelines_.get(call.launch.kernel, call.launch.block, call.launch.variant);
}

Launches::Dispatch Launches::bind(const Call& call, Bindings& bindings) {
  const Pipeline& pipeline = pipeline_of(call);
  const Texels texels = pipeline.reads_texels() ? texels_of(call) : Texels{};
  Dispatch made{.pipeline = &pipeline,
                .set = bindings.sets.get(pipeline, call.buffers, texels, unused_.handle()),
                .groups = call.launch.groups,
                .early = call.early};
  if (pipeline.takes(params_binding)) made.offsets[made.offset_count++] = params_offset(call, bindings.slices);
  if (pipeline.takes(loose_binding)) made.offsets[made.offset_count++] = loose_offset(call, pipeline, bindings.slices);
  return made;
}

void Launches::dispatch(VkCommandBuffer commands, const Dispatch& one) const {
  if (!one.early) kernel_barrier(vk_, commands);
  vk_.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, one.pipeline->handle());
  vk_.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, one.pipeline->layout(), 0, 1, &one.set,
                            one.offset_count, one.offsets.data());
  vk_.CmdDispatch(commands, one.groups[0], one.groups[1], one.groups[2]);
}

void Launches::make_room() {
  const bool full = bindings_.slices.left() < slices_of_launch || bindings_.sets.made() >= most_sets;
  if (!full && !stages_.full()) return;
  stream_.wait();
  stages_.collect();
  forget_buffers();
}

void Launches::forget_buffers() {
  bindings_.slices.forget();
  bindings_.sets.forget();
}

void Launches::launch_call(const Call& call) {
  make_room();
  const Dispatch one = bind(call, bindings_);
  const VkCommandBuffer commands = stream_.open();
  stages_.time(stage_name(call.launch), commands, [&] { dispatch(commands, one); });
  stream_.recorded();
}

StepApi::Recording Launches::record(const std::vector<Call>& calls, uint steps) {
  const auto made = std::make_shared<Recorded>(*this, slices_of_launch * uint32_t(calls.size()) + 1);
  std::vector<Dispatch> step;
  for (const Call& call : calls) step.push_back(bind(call, made->bindings));
  stream_.begin(made->commands, VK_COMMAND_BUFFER_USAGE_SIMULTANEOUS_USE_BIT);
  for (uint k = 0; k < steps; ++k)
    for (const Dispatch& one : step) dispatch(made->commands, one);
  stream_.end(made->commands);
  made->dispatches = steps * uint(step.size());
  return made;
}

void Launches::replay(const Recording& recording) {
  Recorded& recorded = *static_cast<Recorded*>(recording.get());
  recorded.number = stream_.number();
  stream_.append(recorded.commands, recorded.dispatches);
}

}  // namespace spherepair
