// SPDX-License-Identifier: MIT
#include "cuda/host/cuda_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "common/backend/checks.h"
#include "common/device/hazards.h"
#include "common/shared/tensor_form.h"
#include "cuda/host/caller_arrays.h"
#include "cuda/host/check.h"
#include "cuda/host/device_choice.h"
#include "cuda/host/early_launch.h"
#include "cuda/host/entries.h"
#include "cuda/host/library_sort.h"
#include "cuda/host/sort_pairs.h"
#include "cuda/host/stage_events.h"
#include "cuda/host/step_graph.h"

namespace spherepair {
namespace {

template <typename T = void>
T* data_of(uint64_t handle) {
  return reinterpret_cast<T*>(uintptr_t(handle));
}

class CudaDevice final : public Device, private DeviceLibrary {
 public:
  CudaDevice(int device, int before);
  const BackendInfo& info() const override { return info_; }
  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  void enter_thread() override {
    cuda_check(cudaGetDevice(&before_), "asking for the device");
    cuda_check(cudaSetDevice(device_), "choosing the device");
  }
  void leave_thread() noexcept override { cudaSetDevice(before_); }

  Memory allocate(uint64_t bytes, Memory replaced) override;
  void write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) override;
  void read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) override;
  std::shared_ptr<char[]> host_memory(uint64_t bytes) override;
  void clear(const Memory& memory, uint64_t bytes) override;
  void launch(const Launch& launch, const Params& params, const BufferHandles& buffers) override;
  void wait() override;

  void check(const CollideOptions& options) const override;
  void begin_step(const ApiOptions& options) override;
  void end_step() override;

  void time_stages(bool on) override;
  std::vector<StageTime> stage_times() override;
  DeviceLibrary* library() override { return this; }
  DeviceArrays* arrays() override { return &arrays_; }
  void flush() override { recorder_.flush(); }

 private:
  void sort_spheres(const Params& params, const BufferHandles& buffers) override;
  void sort_pairs(const Memory& pairs, uint64_t count) override;

  void require_kernels(int device);

  const int device_;
  int before_;  // device that leave_thread restores
  BackendInfo info_;
  DeviceCapabilities capabilities_;
  StepGraphs graphs_;
  StepRecorder recorder_{graphs_, work, prepared};
  CallerArrays arrays_;
  LibrarySort library_;
  StageEvents stages_;
  std::unordered_set<Entry> loaded_;  // kernels launched so far
  bool programmatic_ = false;         // a launch can begin before the previous one ends
  bool batched_ = true;               // false: the host waits for each launch of this step
  bool overlaps_ = true;              // launches without a hazard overlap, in this step and after it
  Hazards hazards_;                   // writes, clears and Thrust reset it
};

CudaDevice::CudaDevice(int device, int before)
    : device_(device),
      before_(before),
      info_(describe_device(device)),
      capabilities_{.largest_buffer = uint64_t(1) << 47,
                    .atomics_64 = true,
                    .overlaps_images = false,
                    .makes_lists = true,
                    .bounds_block = SERVICE_BLOCK,
                    .tensor_groups = tensor_groups(device),
                    .tensor_block = TENSOR_BLOCK,
                    .persistent_groups = persistent_groups(device)},
      arrays_(device, [this](cudaStream_t stream) {
        recorder_.flush();
        hazards_.forget();
        graphs_.use_stream(stream);
      }) {
  require_kernels(device);
}

void CudaDevice::require_kernels(int device) {
  cudaFuncAttributes attributes;
  const cudaError_t error = cudaFuncGetAttributes(&attributes, empty_kernel(SERVICE_BLOCK, {}));
  int runtime = 0, driver = 0;
  cudaRuntimeGetVersion(&runtime);
  cudaDriverGetVersion(&driver);
  const bool captured = std::min(runtime, driver) >= 12030;                         // graphs can capture it
  programmatic_ = captured && error == cudaSuccess && attributes.ptxVersion >= 90;  // else compiled without waits
  if (error == cudaSuccess) return;
  const std::string capability = info_.details.at("compute capability");
  throw BackendError(
      fmt::format("cuda: the kernels of this build do not run on device {}, {} of compute capability {} ({}); "
                  "configure with -DCMAKE_CUDA_ARCHITECTURES=native",
                  device, info_.device, capability, cudaGetErrorString(error)));
}

Memory CudaDevice::allocate(uint64_t bytes, Memory replaced) {
  recorder_.flush();
  hazards_.forget();
  replaced = {};
  void* data = nullptr;
  const cudaError_t error = cudaMalloc(&data, bytes);
  if (error == cudaErrorMemoryAllocation) {
    size_t free = 0, total = 0;
    cudaGetLastError();
    cudaMemGetInfo(&free, &total);
    throw BackendError(fmt::format(
        "cuda: out of memory: {} bytes asked, {} of {} free; use fewer spheres or no pair list", bytes, free, total));
  }
  cuda_check(error, fmt::format("allocating {} bytes", bytes));
  ++prepared.allocations;
  return {handle_of(data), bytes, std::shared_ptr<void>(data, cudaFree)};
}

void CudaDevice::wait() {
  recorder_.flush();
  cuda_check(cudaDeviceSynchronize(), "waiting for the device");
}

void CudaDevice::write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  recorder_.flush();
  hazards_.forget();
  char* target = data_of<char>(memory.handle) + offset;
  cuda_check(cudaMemcpyAsync(target, data, bytes, cudaMemcpyHostToDevice, arrays_.stream()),
             fmt::format("writing {} bytes", bytes));
}

void CudaDevice::read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  recorder_.flush();
  arrays_.read(data_of<const char>(memory.handle) + offset, data, bytes);
}

std::shared_ptr<char[]> CudaDevice::host_memory(uint64_t bytes) {
  char* data = nullptr;
  cuda_check(cudaMallocHost(&data, bytes), fmt::format("pinning {} bytes of the host's memory", bytes));
  return {data, cudaFreeHost};
}

void CudaDevice::launch(const Launch& launch, const Params& params, const BufferHandles& buffers) {
  Call call{launch, params, seen_buffers(launch, buffers)};
  if (launch.view) call.view = *std::exchange(call.launch.view, nullptr);
  call.params.indices = launch.variant.indices;
  const bool must_wait = !programmatic_ || !overlaps_ || !waits_last(launch.kernel);
  const bool overlaps = hazards_.overlaps(launch, buffers, must_wait);
  prepared.compilations += loaded_.insert(entry_of(launch)).second;
  call.params.waits_first = programmatic_ && overlaps_ && !overlaps && waits_first(launch, params);
  call.early = overlaps || call.params.waits_first;
  work.early += call.params.waits_first;
  work.overlapped += overlaps;
  if (recorder_.collecting()) return recorder_.add(call);
  recorder_.flush();  // submits steps that are held back
  ++work.launches;
  stages_.time(stage_name(launch), [&] { graphs_.launch_call(call); });
  if (!batched_) wait(), ++work.waits;
}

void CudaDevice::check(const CollideOptions& options) const {
  refuse_missing("cuda", options, {.graph = true, .library_clear = true, .batch = true, .overlap = programmatic_},
                 true);
}

void CudaDevice::begin_step(const ApiOptions& options) {
  batched_ = options.batch.value_or(true);
  if (options.graph.value_or(true) && batched_ && !stages_.on())  // stages are timed one by one
    recorder_.begin(options.graph_steps.value_or(graph_sizes.back()));
  overlaps_ = options.overlap.value_or(true);
}

void CudaDevice::end_step() {
  batched_ = true;
  recorder_.end();
}

void CudaDevice::clear(const Memory& memory, uint64_t bytes) {
  recorder_.flush();
  hazards_.forget();
  stages_.time("memset", [&] {
    cuda_check(cudaMemsetAsync(data_of(memory.handle), 0, bytes, arrays_.stream()), "clearing a buffer");
  });
}

void CudaDevice::sort_spheres(const Params& params, const BufferHandles& buffers) {
  recorder_.flush();
  hazards_.forget();
  stages_.time("thrust_sort", [&] {
    library_.sort(params, data_of<vec4>(buffers[SLOT_POSITION]), data_of<uint>(buffers[SLOT_CELL]),
                  data_of<vec4>(buffers[SLOT_SORTED]), data_of<uint>(buffers[SLOT_ID]),
                  data_of<uint>(buffers[SLOT_SORTED_COUNT]));
  });
  prepared.allocations += library_.take_allocations();
}

void CudaDevice::sort_pairs(const Memory& pairs, uint64_t count) {
  spherepair::sort_pairs(data_of(pairs.handle), count);
}

void CudaDevice::time_stages(bool on) {
  stage_times();
  stages_.turn(on);
}

std::vector<StageTime> CudaDevice::stage_times() {
  wait();
  return stages_.take();
}

}  // namespace

std::unique_ptr<Device> open_cuda_device(const OpenOptions& options) {
  int before = 0;
  cudaGetDevice(&before);  // fails without a driver; later calls report it
  return std::make_unique<CudaDevice>(use_device(DeviceName(options.cuda_device)), before);
}

}  // namespace spherepair
