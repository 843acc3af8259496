// SPDX-License-Identifier: MIT
#include "cuda/host/caller_arrays.h"

#include <fmt/format.h>

#include "cuda/host/check.h"
#include "cuda/host/list_arrays.h"

namespace spherepair {

CallerArrays::~CallerArrays() {
  if (last_used_) cudaEventDestroy(last_used_);
}

bool CallerArrays::has(const void* data, int number) const {
  cudaPointerAttributes attributes{};
  const bool known = cudaPointerGetAttributes(&attributes, data) == cudaSuccess;
  cudaGetLastError();
  const bool managed = attributes.type == cudaMemoryTypeManaged;
  return known && number == device_ &&
         (managed || (attributes.type == cudaMemoryTypeDevice && attributes.device == device_));
}

bool CallerArrays::is_captured() const {
  cudaStreamCaptureStatus status = cudaStreamCaptureStatusNone;
  const bool known = cudaStreamIsCapturing(stream_, &status) == cudaSuccess;
  cudaGetLastError();
  return known && status != cudaStreamCaptureStatusNone;
}

// Waits for the last call's stream, since all calls use the same buffers of lists.
void CallerArrays::begin(void* stream) {
  stream_ = static_cast<cudaStream_t>(stream);
  use_(stream_);
  if (last_used_ && !is_captured()) cuda_check(cudaStreamWaitEvent(stream_, last_used_), "waiting for another stream");
}

void CallerArrays::end() noexcept {
  if (!is_captured()) {
    if (!last_used_) cudaEventCreateWithFlags(&last_used_, cudaEventDisableTiming);
    cudaEventRecord(last_used_, stream_);
  }
  stream_ = nullptr;
  use_(nullptr);
}

void CallerArrays::read(const void* data, void* to, uint64_t bytes) {
  cuda_check(cudaMemcpyAsync(to, data, bytes, cudaMemcpyDeviceToHost, stream_), fmt::format("reading {} bytes", bytes));
  cuda_check(cudaStreamSynchronize(stream_), "waiting for what is read");
}

void CallerArrays::read_points(const DeviceArray& points, const DeviceArray& radii, const Memory& to, uint64_t first,
                               uint64_t rows) {
  gather_points(stream_, points, radii, reinterpret_cast<dvec4*>(uintptr_t(to.handle)) + first, rows);
}

void CallerArrays::write_columns(const BufferHandles& list, uint64_t looking, int64_t room, const DeviceColumns& to) {
  write_list_columns(stream_, list, looking, room, to);
}

}  // namespace spherepair
