// SPDX-License-Identifier: MIT
// Reads the energy counter and the power of a GPU by NVML. Loads NVML on first use: the program builds and starts
// without it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace spherepair {

class PowerMeter {
 public:
  // For the GPU with this UUID, 32 hex digits as from a backend. Throws BackendError without the library, the GPU
  // (lists the GPUs) or an energy counter.
  explicit PowerMeter(const std::string& uuid, const std::string& library = "libnvidia-ml.so.1");
  ~PowerMeter();

  uint64_t millijoules() const;  // of the energy counter, from an arbitrary start
  double watts() const;          // now or, if the GPU does not report that, the mean of about a second
  bool instant() const;          // whether watts() are those of now

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  void* device_ = nullptr;
  bool instant_ = false;
};

}  // namespace spherepair
