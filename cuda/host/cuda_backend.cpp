// SPDX-License-Identifier: MIT
#include "cuda/host/cuda_backend.h"

#include <fmt/format.h>

#include <utility>

#include "common/backend/checks.h"
#include "common/backend/method_choice.h"
#include "common/device/device_backend.h"
#include "cuda/host/check.h"
#include "cuda/host/device_choice.h"
#include "cuda/host/entries.h"
#include "cuda/host/l2_aside.h"
#include "cuda/host/library_sort.h"
#include "cuda/host/sort_pairs.h"
#include "cuda/host/stage_events.h"
#include "cuda/host/step_graph.h"

namespace spherepair {
namespace {

// Owns a chunk of device memory.
struct DeviceMemory {
  void* data = nullptr;
  ~DeviceMemory() { cudaFree(data); }
};

class CudaBackend final : public DeviceBackend {
 public:
  explicit CudaBackend(int device);
  const BackendInfo& info() const override { return info_; }
  void finish() override;
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
  bool graph_pays() const override { return spheres() < 20'000; }  // one by one, few take the host the longer time
  void check_api_options(const CollideOptions& options) const override;
  void begin_step(const ApiOptions& api) override;
  void end_step() override;
  void clear_buffer(uint slot, uint64_t bytes) override;
  void library_scan() override;
  void library_sort() override;

 private:
  template <typename T>
  T* buffer(uint slot) const {
    return static_cast<T*>(memory_[slot].data);
  }
  KernelBuffers world(const Launch& launch) const;
  uint64_t table_bytes() const { return (uint64_t(params().cell_slots) + 2) * sizeof(uint); }
  void require_kernels(int device);

  BackendInfo info_;
  std::array<DeviceMemory, SLOT_TOTAL> memory_;
  StepGraph graph_;
  LibrarySort library_;
  L2Aside l2_;
  StageEvents stages_;
  bool programmatic_ = false;   // a launch can begin before the one before it is done
  bool early_ = false;          // and does, in this step
  std::optional<Kernel> last_;  // that was launched; writes, clears and Thrust forget it
};

CudaBackend::CudaBackend(int device) : info_(describe_device(device)), l2_(device) { require_kernels(device); }

void CudaBackend::require_kernels(int device) {
  cudaFuncAttributes attributes;
  const cudaError_t error = cudaFuncGetAttributes(&attributes, empty_kernel(SERVICE_BLOCK, {}));
  programmatic_ = error == cudaSuccess && attributes.ptxVersion >= 90;  // else kernels were compiled without waits
  if (error == cudaSuccess) return;
  const std::string capability = info_.details.at("compute capability");
  throw BackendError(
      fmt::format("cuda: the kernels of this build do not run on device {}, {} of compute capability {} ({}); "
                  "configure with -DCMAKE_CUDA_ARCHITECTURES=native",
                  device, info_.device, capability, cudaGetErrorString(error)));
}

void CudaBackend::allocate(uint slot, uint64_t bytes) {
  graph_.flush();
  last_.reset();
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

void CudaBackend::finish() {
  graph_.flush();
  cuda_check(cudaDeviceSynchronize(), "waiting for the device");
}

void CudaBackend::write(uint slot, const void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  graph_.flush();
  last_.reset();
  char* target = static_cast<char*>(memory_[slot].data) + offset;
  cuda_check(cudaMemcpy(target, data, bytes, cudaMemcpyHostToDevice), fmt::format("writing {} bytes", bytes));
}

void CudaBackend::read(uint slot, void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  graph_.flush();
  const char* source = static_cast<const char*>(memory_[slot].data) + offset;
  cuda_check(cudaMemcpy(data, source, bytes, cudaMemcpyDeviceToHost), fmt::format("reading {} bytes", bytes));
}

KernelBuffers CudaBackend::world(const Launch& launch) const {
  return {.position = buffer<vec4>(position_slot(launch.order)),
          .velocity = buffer<vec4>(SLOT_VELOCITY),
          .count = buffer<uint>(count_slot(launch)),
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
          .bucket_cursor = buffer<uint>(SLOT_BUCKET),
          .visible = buffer<uvec2>(SLOT_VISIBLE),
          .image = buffer<uint>(SLOT_IMAGE),
          .tile = buffer<uvec2>(SLOT_TILE),
          .drawn = buffer<uint>(SLOT_DRAWN),
          .cluster = buffer<vec4>(SLOT_CLUSTER),
          .seen_left = buffer<uint>(SLOT_SEEN_LEFT),
          .cluster_list = buffer<uint>(SLOT_CLUSTER_LIST),
          .pyramid = buffer<uvec2>(SLOT_PYRAMID),
          .wide = buffer<void>(SLOT_WIDE),
          .anchor = buffer<vec4>(SLOT_ANCHOR),
          .flight = buffer<void>(SLOT_FLIGHT),
          .since = buffer<uint>(SLOT_SINCE),
          .next_event = buffer<uint>(SLOT_NEXT_EVENT),
          .seen_list = buffer<uint>(SLOT_SEEN_LIST)};
}

void CudaBackend::launch(const Launch& launch, const Params& params) {
  const dim3 groups(launch.groups[0], launch.groups[1], launch.groups[2]);
  const View seen = takes_view(launch.kernel) ? view() : View{};
  KernelCall call{stage_name(launch), entry_of(launch), groups, launch.block, params, world(launch), seen, {}, false};
  call.window = l2_.window(memory_[SLOT_CELL].data, table_bytes());
  const bool overlaps_previous = programmatic_ && last_ && launch.overlaps_previous == last_;
  const bool waits_first = launch.kernel == Kernel::grid_sort || launch.kernel == Kernel::collide_grid;
  call.early = overlaps_previous || (early_ && waits_first);
  work_.early += call.early && !overlaps_previous;
  if (overlaps_previous) graph_.flush();  // a graph would wait for all before it
  work_.overlapped += overlaps_previous;
  last_ = launch.kernel;
  ++work_.launches;
  if (graph_.collecting()) return graph_.add(call);
  stages_.time(call.name, [&] { launch_call(call, nullptr); });
}

void CudaBackend::check_api_options(const CollideOptions& options) const {
  refuse_missing("cuda", options,
                 {.graph = true, .keep_in_l2 = l2_.bytes() > 0, .library_clear = true, .overlap = programmatic_}, true);
}

void CudaBackend::begin_step(const ApiOptions& api) {
  l2_.turn(api.keep_in_l2.value_or(false));
  if (api.graph.value_or(true) && !stages_.on()) graph_.begin();  // stages are timed one by one
  early_ = programmatic_ && api.overlap.value_or(true) && (!graph_.collecting() || StepGraph::may_be_early());
}

void CudaBackend::end_step() {
  const uint64_t calls = graph_.size();
  const bool replayed = graph_.end();
  if (!replayed) return;
  ++work_.graphs_replayed;
  work_.launches -= calls - 1;
}

void CudaBackend::clear_buffer(uint slot, uint64_t bytes) {
  graph_.flush();
  last_.reset();
  stages_.time("memset", [&] { cuda_check(cudaMemsetAsync(memory_[slot].data, 0, bytes), "clearing a buffer"); });
}

void CudaBackend::library_scan() {
  graph_.flush();
  last_.reset();
  stages_.time("thrust_scan", [&] { library_.scan(buffer<uint>(SLOT_CELL), table_bytes() / sizeof(uint)); });
}

void CudaBackend::library_sort() {
  graph_.flush();
  last_.reset();
  stages_.time("thrust_sort", [&] {
    library_.sort(params(), buffer<vec4>(SLOT_POSITION), buffer<uint>(SLOT_CELL), buffer<vec4>(SLOT_SORTED),
                  buffer<uint>(SLOT_ID), buffer<uint>(SLOT_SORTED_COUNT));
  });
}

std::vector<Pair> CudaBackend::read_pairs(uint64_t count) {
  sort_pairs(memory_[SLOT_PAIR].data, count);
  std::vector<Pair> pairs(count);
  read(SLOT_PAIR, pairs.data(), 0, count * sizeof(Pair));
  return pairs;
}

void CudaBackend::time_stages(bool on) {
  stage_times();
  stages_.turn(on);
}

std::vector<StageTime> CudaBackend::stage_times() {
  finish();
  return stages_.take();
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
  return std::make_unique<CudaBackend>(use_device(options.cuda_device));
}

}  // namespace spherepair
