// SPDX-License-Identifier: MIT
// Reads the energy counter, the power and the used memory of a GPU by NVML. Loads NVML on first use: the program builds
// and starts without it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace spherepair {

struct Nvml;  // the library

class GpuMeter {
 public:
  // For the GPU with this UUID, 32 hex digits as from a backend. Throws BackendError without the library, the GPU
  // (lists the GPUs) or an energy counter.
  explicit GpuMeter(const std::string& uuid, const std::string& library = "libnvidia-ml.so.1");
  ~GpuMeter();

  uint64_t millijoules() const;  // of the energy counter, from an arbitrary start
  double watts() const;          // now or, if the GPU does not report that, the mean of about a second
  bool instant() const;          // whether watts() are those of now

 private:
  std::unique_ptr<Nvml> library_;
  void* device_ = nullptr;
  bool instant_ = false;
};

// Bytes that all processes use of each GPU, by its UUID. Throws BackendError without the library.
std::map<std::string, uint64_t> used_gpu_memory(const std::string& library = "libnvidia-ml.so.1");

}  // namespace spherepair
