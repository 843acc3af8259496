// SPDX-License-Identifier: MIT
#include "cuda_backend.h"

#include <fmt/format.h>

#include <utility>

#include "check.h"
#include "device_backend.h"
#include "device_choice.h"
#include "entries.h"
#include "sort_pairs.h"

namespace spherepair {
namespace {

// Owns a chunk of device memory.
struct DeviceMemory {
  void* data = nullptr;
  ~DeviceMemory() { cudaFree(data); }
};

struct TimedStage {
  Kernel kernel;
  cudaEvent_t start, stop;
};

class CudaBackend final : public DeviceBackend {
 public:
  explicit CudaBackend(const OpenOptions& options);
  ~CudaBackend() override;
  const BackendInfo& info() const override { return info_; }
  void finish() override { cuda_check(cudaDeviceSynchronize(), "waiting for the device"); }
  void time_stages(bool on) override;
  std::vector<StageTime> stage_times() override;
  DeviceMemoryView shared(uint slot, uint64_t bytes_a_sphere);

 protected:
  void allocate(uint slot, uint64_t bytes) override;
  void write(uint slot, const void* data, uint64_t offset, uint64_t bytes) override;
  void read(uint slot, void* data, uint64_t offset, uint64_t bytes) override;
  void launch(const Launch& launch, const Params& params) override;
  uint64_t largest_binding() const override { return uint64_t(1) << 47; }
  std::vector<Pair> read_pairs(uint64_t count) override;
  bool has_atomics_64() const override { return true; }

 private:
  template <typename T>
  T* buffer(uint slot) const {
    return static_cast<T*>(memory_[slot].data);
  }
  World world(const Launch& launch) const;
  void describe(int device);
  void require_kernels(int device) const;

  BackendInfo info_;
  std::array<DeviceMemory, SLOT_TOTAL> memory_;
  bool timing_ = false;
  std::vector<TimedStage> timed_;
};

CudaBackend::CudaBackend(const OpenOptions& options) {
  const int device = usable_device(options.cuda_device);
  cuda_check(cudaSetDevice(device), fmt::format("choosing device {}", device));
  describe(device);
  require_kernels(device);
}

CudaBackend::~CudaBackend() {
  for (const TimedStage& stage : timed_) {
    cudaEventDestroy(stage.start);
    cudaEventDestroy(stage.stop);
  }
}

void CudaBackend::describe(int device) {
  cudaDeviceProp properties;
  cuda_check(cudaGetDeviceProperties(&properties, device), "reading the device's properties");
  int driver = 0, runtime = 0, clock_khz = 0;
  cudaDriverGetVersion(&driver);
  cudaRuntimeGetVersion(&runtime);
  cudaDeviceGetAttribute(&clock_khz, cudaDevAttrClockRate, device);
  info_.name = "cuda";
  info_.device = properties.name;
  for (const char byte : properties.uuid.bytes) info_.uuid += fmt::format("{:02x}", uint(uint8_t(byte)));
  info_.device_timers = true;
  info_.details = {{"compute capability", fmt::format("{}.{}", properties.major, properties.minor)},
                   {"driver supports CUDA", version_text(driver)},
                   {"CUDA runtime", version_text(runtime)},
                   {"multiprocessors", std::to_string(properties.multiProcessorCount)},
                   {"highest clock MHz", std::to_string(clock_khz / 1000)},
                   {"memory bytes", std::to_string(properties.totalGlobalMem)},
                   {"L2 bytes", std::to_string(properties.l2CacheSize)}};
}

void CudaBackend::require_kernels(int device) const {
  cudaFuncAttributes attributes;
  const cudaError_t error = cudaFuncGetAttributes(&attributes, empty_kernel(SERVICE_BLOCK, {}));
  if (error == cudaSuccess) return;
  const std::string capability = info_.details.at("compute capability");
  throw BackendError(
      fmt::format("cuda: the kernels of this build do not run on device {}, {} of compute capability {} ({}); "
                  "configure with -DCMAKE_CUDA_ARCHITECTURES=native",
                  device, info_.device, capability, cudaGetErrorString(error)));
}

void CudaBackend::allocate(uint slot, uint64_t bytes) {
  cuda_check(cudaFree(std::exchange(memory_[slot].data, nullptr)), "freeing a buffer");
  const cudaError_t error = cudaMalloc(&memory_[slot].data, bytes);
  if (error == cudaErrorMemoryAllocation) {
    size_t free = 0, total = 0;
    cudaGetLastError();
    cudaMemGetInfo(&free, &total);
    throw BackendError(fmt::format(
        "cuda: out of memory: {} bytes asked, {} of {} free; use fewer spheres or no pair list", bytes, free, total));
  }
  cuda_check(error, fmt::format("allocating {} bytes", bytes));
}

void CudaBackend::write(uint slot, const void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  char* target = static_cast<char*>(memory_[slot].data) + offset;
  cuda_check(cudaMemcpy(target, data, bytes, cudaMemcpyHostToDevice), fmt::format("writing {} bytes", bytes));
}

void CudaBackend::read(uint slot, void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  const char* source = static_cast<const char*>(memory_[slot].data) + offset;
  cuda_check(cudaMemcpy(data, source, bytes, cudaMemcpyDeviceToHost), fmt::format("reading {} bytes", bytes));
}

World CudaBackend::world(const Launch& launch) const {
  return {.position = buffer<vec4>(position_slot(launch.order)),
          .velocity = buffer<vec4>(SLOT_VELOCITY),
          .count = buffer<uint>(count_slot(launch.order)),
          .summary = buffer<uint>(SLOT_SUMMARY),
          .deferred = buffer<uvec2>(SLOT_DEFERRED),
          .listed = buffer<uvec2>(SLOT_PAIR),
          .spheres = buffer<vec4>(SLOT_SPHERES),
          .verdict = buffer<uint>(SLOT_VERDICT),
          .cell = buffer<uint>(launch.table),
          .from_id = buffer<uint>(id_slot(launch.order)),
          .sorted = buffer<vec4>(position_slot(launch.target)),
          .id = buffer<uint>(id_slot(launch.target)),
          .sorted_count = buffer<uint>(SLOT_SORTED_COUNT),
          .tile_sum = buffer<uint>(SLOT_SCAN),
          .next_place = buffer<uint>(SLOT_BUCKET),
          .visible = buffer<uvec2>(SLOT_VISIBLE),
          .image = buffer<uint>(SLOT_IMAGE),
          .tile = buffer<uvec2>(SLOT_TILE),
          .drawn = buffer<uint>(SLOT_DRAWN),
          .cluster = buffer<vec4>(SLOT_CLUSTER),
          .cluster_seen = buffer<uint>(SLOT_CLUSTER_SEEN),
          .cluster_list = buffer<uint>(SLOT_CLUSTER_LIST),
          .pyramid = buffer<uint>(SLOT_PYRAMID),
          .wide = buffer<void>(SLOT_WIDE),
          .anchor = buffer<vec4>(SLOT_ANCHOR),
          .flight = buffer<void>(SLOT_FLIGHT),
          .since = buffer<uint>(SLOT_SINCE),
          .due = buffer<uint>(SLOT_DUE)};
}

void CudaBackend::launch(const Launch& launch, const Params& params) {
  Params p = params;
  World w = world(launch);
  View v = view();
  void* arguments[] = {&p, &w, &v};  // a kernel that draws nothing takes the first two
  const dim3 groups(launch.groups[0], launch.groups[1], launch.groups[2]);
  TimedStage stage{launch.kernel, nullptr, nullptr};
  if (timing_) {
    cuda_check(cudaEventCreate(&stage.start), "creating an event");
    cuda_check(cudaEventCreate(&stage.stop), "creating an event");
    cuda_check(cudaEventRecord(stage.start), "recording an event");
  }
  cuda_check(cudaLaunchKernel(entry_of(launch), groups, dim3(launch.block), arguments, 0, nullptr),
             fmt::format("launching {} with {} threads a block", kernel_name(launch.kernel), launch.block));
  if (timing_) {
    cuda_check(cudaEventRecord(stage.stop), "recording an event");
    timed_.push_back(stage);
  }
}

std::vector<Pair> CudaBackend::read_pairs(uint64_t count) {
  sort_pairs(memory_[SLOT_PAIR].data, count);
  std::vector<Pair> pairs(count);
  read(SLOT_PAIR, pairs.data(), 0, count * sizeof(Pair));
  return pairs;
}

void CudaBackend::time_stages(bool on) {
  stage_times();
  timing_ = on;
}

std::vector<StageTime> CudaBackend::stage_times() {
  finish();
  std::vector<StageTime> times;
  for (const TimedStage& stage : timed_) {
    float milliseconds = 0;
    cuda_check(cudaEventElapsedTime(&milliseconds, stage.start, stage.stop), "reading an event");
    times.push_back({kernel_name(stage.kernel), milliseconds * 1e-3});
    cudaEventDestroy(stage.start);
    cudaEventDestroy(stage.stop);
  }
  timed_.clear();
  return times;
}

DeviceMemoryView CudaBackend::shared(uint slot, uint64_t bytes_a_sphere) {
  ready_to_draw();
  return {memory_[slot].data, spheres() * bytes_a_sphere};
}

CudaBackend& cuda_backend(Backend& backend) {
  if (auto* cuda = dynamic_cast<CudaBackend*>(&backend)) return *cuda;
  throw BackendError(
      fmt::format("{} is not the CUDA backend: only CUDA's spheres are handed over to OpenGL", backend.info().name));
}

}  // namespace

DeviceMemoryView cuda_positions(Backend& backend) { return cuda_backend(backend).shared(SLOT_POSITION, sizeof(vec4)); }
DeviceMemoryView cuda_contacts(Backend& backend) { return cuda_backend(backend).shared(SLOT_COUNT, sizeof(uint)); }

std::unique_ptr<Backend> open_cuda_backend(const OpenOptions& options) {
  return std::make_unique<CudaBackend>(options);
}

}  // namespace spherepair
