// SPDX-License-Identifier: MIT
// Callers' arrays in CUDA's memory, and the stream that all of the device's launches and copies go to.
#pragma once

#include <cuda_runtime.h>

#include <functional>

#include "common/device/device_arrays.h"

namespace spherepair {

class CallerArrays final : public DeviceArrays {
 public:
  // use: submits what is held back, and sends later work to the stream.
  CallerArrays(int device, std::function<void(cudaStream_t)> use) : device_(device), use_(std::move(use)) {}
  ~CallerArrays() override;
  CallerArrays(const CallerArrays&) = delete;
  CallerArrays& operator=(const CallerArrays&) = delete;

  cudaStream_t stream() const { return stream_; }  // null: the default stream

  bool has(const void* data, int number) const override;
  void begin(void* stream) override;
  void end() noexcept override;
  bool is_captured() const override;
  void read(const void* data, void* to, uint64_t bytes) override;
  void read_points(const DeviceArray& points, const DeviceArray& radii, const Memory& to, uint64_t first,
                   uint64_t rows) override;
  void write_columns(const BufferHandles& list, uint64_t looking, int64_t room, const DeviceColumns& to) override;

 private:
  const int device_;
  std::function<void(cudaStream_t)> use_;
  cudaStream_t stream_ = nullptr;
  cudaEvent_t last_used_ = nullptr;  // recorded after the last call
};

}  // namespace spherepair
