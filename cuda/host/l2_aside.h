// SPDX-License-Identifier: MIT
// A part of the L2 cache set aside for one buffer.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

namespace spherepair {

class L2Aside {
 public:
  explicit L2Aside(int device);

  uint64_t bytes() const { return most_; }  // 0: the device cannot
  void turn(bool on);
  bool on() const { return on_; }

  // What a launch must be given so that this buffer stays in the cache, as much of it as there is room for.
  cudaAccessPolicyWindow window(void* data, uint64_t bytes) const;

 private:
  uint64_t most_ = 0, largest_window_ = 0;  // bytes
  bool on_ = false;
};

}  // namespace spherepair
