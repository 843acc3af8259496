// SPDX-License-Identifier: MIT
#include "vulkan/vulkan_device.h"

#include <fmt/format.h>

#include <bit>
#include <utility>

#include "common/backend/checks.h"
#include "common/device/hazards.h"
#include "vulkan/launches.h"
#include "vulkan/staging.h"

namespace spherepair {
namespace {

class VulkanDevice final : public Device {
 public:
  explicit VulkanDevice(const OpenOptions& options);
  const BackendInfo& info() const override { return info_; }
  const DeviceCapabilities& capabilities() const override { return capabilities_; }

  Memory allocate(uint64_t bytes, Memory replaced) override;
  void write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) override;
  void read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) override;
  void clear(const Memory& memory, uint64_t bytes) override;
  void launch(const Launch& launch, const Params& params, const BufferHandles& buffers) override;
  void wait() override;

  void check(const CollideOptions& options) const override;
  void begin_step(const ApiOptions& options) override;
  void end_step() override;
  bool reads_texture(Kernel kernel, const Params& params, uint64_t texels, std::optional<bool> wanted) const override;

  void time_stages(bool on) override { stage_times(), stages_.turn(on); }
  std::vector<StageTime> stage_times() override;
  std::vector<StageTime> compile_kernels() override { return compile_times(device_); }
  void flush() override;

  const LogicalDevice& logical() const { return device_; }
  VkBuffer buffer(uint64_t handle) const { return table_.at(handle); }
  void copy(VkBuffer from, VkBuffer to, uint64_t bytes);  // waits

 private:
  void forget(uint64_t handle);

  LogicalDevice device_;
  BackendInfo info_ = describe_device(device_.limits());
  DeviceCapabilities capabilities_ = capabilities_of(device_.limits());
  BufferTable table_{device_};
  CommandStream stream_{device_};
  Staging staging_{device_, stream_};
  StageQueries stages_{device_};
  Launches launches_{device_, table_, stream_, stages_};
  StepRecorder recorder_{launches_, work, prepared};
  Hazards hazards_;       // forgotten at writes and clears
  bool batched_ = true;   // else the host waits for each launch of this step
  bool overlaps_ = true;  // launches without a hazard may overlap, from this step on
};

VulkanDevice::VulkanDevice(const OpenOptions& options) : device_(options) {}

Memory VulkanDevice::allocate(uint64_t bytes, Memory replaced) {
  recorder_.flush();
  hazards_.forget();
  replaced = {};
  const uint64_t handle = table_.add(bytes);
  ++prepared.allocations;
  return {handle, bytes, std::shared_ptr<void>(this, [this, handle](void*) { forget(handle); })};
}

// Waits first: pending commands may use the buffer, and descriptor sets may refer to it.
void VulkanDevice::forget(uint64_t handle) {
  try {
    wait();
  } catch (const BackendError&) {  // the device has failed, and an earlier call has said so
  }
  launches_.forget_buffers();
  table_.remove(handle);
}

void VulkanDevice::wait() {
  recorder_.flush();
  stream_.wait();
  stages_.collect();
}

void VulkanDevice::flush() {
  recorder_.flush();
  stream_.submit();
}

void VulkanDevice::write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  recorder_.flush();
  hazards_.forget();
  staging_.write(table_.at(memory.handle), static_cast<const char*>(data), offset, bytes);
}

void VulkanDevice::read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  recorder_.flush();
  staging_.read(table_.at(memory.handle), static_cast<char*>(data), offset, bytes);
}

void VulkanDevice::copy(VkBuffer from, VkBuffer to, uint64_t bytes) {
  recorder_.flush();
  const Calls& vk = device_.calls();
  const VkCommandBuffer commands = stream_.open();
  barrier_before_transfer(vk, commands);
  const VkBufferCopy range{0, 0, bytes};
  vk.CmdCopyBuffer(commands, from, to, 1, &range);
  barrier_behind_transfer(vk, commands);
  stream_.recorded();
  wait();
}

void VulkanDevice::clear(const Memory& memory, uint64_t bytes) {
  recorder_.flush();
  hazards_.forget();
  launches_.make_room();
  const Calls& vk = device_.calls();
  const VkCommandBuffer commands = stream_.open();
  barrier_before_transfer(vk, commands);
  stages_.time("vk_fill", commands,
               [&] { vk.CmdFillBuffer(commands, table_.at(memory.handle), 0, VkDeviceSize(bytes), 0); });
  barrier_behind_transfer(vk, commands);
  stream_.recorded();
}

void VulkanDevice::launch(const Launch& launch, const Params& params, const BufferHandles& buffers) {
  Call call{launch, params, seen_buffers(launch, buffers)};
  // Not bound, or the validation layer would have to expect writes to them.
  for (Slots left = launch.unused; left != 0; left &= left - 1) call.buffers[std::countr_zero(left)] = 0;
  if (launch.view) call.view = *std::exchange(call.launch.view, nullptr);
  call.launch.variant.folded = launch.groups[1] > 1 || params.first_group != 0;
  launches_.prepare(call);
  prepared.compilations = launches_.compiled();
  call.early = hazards_.overlaps(launch, buffers, !batched_ || !overlaps_);
  work.overlapped += call.early;
  if (recorder_.collecting()) return recorder_.add(call);
  recorder_.flush();  // launches the collected steps
  ++work.launches;
  launches_.launch_call(call);
  if (!batched_) wait(), ++work.waits;
}

void VulkanDevice::check(const CollideOptions& options) const {
  refuse_missing(info_.name, options,
                 {.graph = true, .texture_table = true, .library_clear = true, .batch = true, .overlap = true}, false);
}

void VulkanDevice::begin_step(const ApiOptions& options) {
  batched_ = options.batch.value_or(true);
  overlaps_ = options.overlap.value_or(true);
  if (options.graph.value_or(true) && batched_ && !stages_.on())  // stages are timed one by one
    recorder_.begin(options.graph_steps.value_or(graph_sizes.back()));
}

void VulkanDevice::end_step() {
  batched_ = true;
  recorder_.end();
}

bool VulkanDevice::reads_texture(Kernel, const Params&, uint64_t texels, std::optional<bool> wanted) const {
  const uint64_t most = device_.limits().largest_texture;
  if (wanted.value_or(false) && texels > most)
    throw BackendError(
        fmt::format("vulkan: {} cells or spheres, which do not fit texel buffers of {} elements; leave the texture out",
                    texels, most));
  return wanted.value_or(true) && texels <= most;
}

std::vector<StageTime> VulkanDevice::stage_times() {
  wait();
  return stages_.take();
}

class ExportedBuffer final : public ExportedMemory {
 public:
  ExportedBuffer(VulkanDevice& device, uint64_t bytes)
      : device_(device), buffer_(device.logical(), bytes, Place::exported) {}
  uint64_t bytes() const override { return buffer_.allocated(); }
  int descriptor() const override { return buffer_.descriptor(); }
  void copy(uint64_t from) override { device_.copy(device_.buffer(from), buffer_.handle(), buffer_.bytes()); }
  void copy_back(uint64_t to) override { device_.copy(buffer_.handle(), device_.buffer(to), buffer_.bytes()); }

 private:
  VulkanDevice& device_;
  DeviceBuffer buffer_;
};

}  // namespace

std::unique_ptr<Device> open_vulkan_device(const OpenOptions& options) {
  return std::make_unique<VulkanDevice>(options);
}

bool exports_memory(const Device& vulkan) {
  return static_cast<const VulkanDevice&>(vulkan).logical().limits().exports_memory;
}

std::unique_ptr<ExportedMemory> export_memory(Device& vulkan, uint64_t bytes) {
  return std::make_unique<ExportedBuffer>(static_cast<VulkanDevice&>(vulkan), bytes);
}

}  // namespace spherepair
