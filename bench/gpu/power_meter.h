// SPDX-License-Identifier: MIT
// The energy counter and the power of a GPU, by NVML, which is loaded when it is needed: the program neither needs
// it to be built nor to start.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace spherepair {

class PowerMeter {
 public:
  // Of the GPU with this UUID, 32 hex digits as a backend tells it. Throws BackendError: without the library, without
  // the GPU (names those that are there) and without an energy counter.
  explicit PowerMeter(const std::string& uuid, const std::string& library = "libnvidia-ml.so.1");
  ~PowerMeter();

  uint64_t millijoules() const;  // of the energy counter, since some moment
  double watts() const;          // now, or where the GPU does not tell that the mean of about a second
  bool instant() const;          // which of both

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  void* device_ = nullptr;
  bool instant_ = false;
};

}  // namespace spherepair
