// SPDX-License-Identifier: MIT
// The buffers of one simulation, by slot (layout.h): their sizes, and guard words behind each.
#pragma once

#include <array>
#include <vector>

#include "common/device/device.h"

namespace spherepair {

class Buffers {
 public:
  explicit Buffers(Device& device) : device_(device) {}

  // For so many spheres, in messages.
  void set_spheres(uint64_t n) { spheres_ = n; }

  // So many bytes at a slot; what was there stays only where the size is the same. Throws BackendError when a kernel
  // of the device cannot reach as many, or memory has no room.
  void resize(uint slot, uint64_t bytes);
  bool grow(uint slot, uint64_t bytes);  // where it has fewer; true: what was there is lost
  uint64_t bytes(uint slot) const { return bytes_[slot]; }
  void swap(uint a, uint b);

  template <typename T>
  void write(uint slot, const std::vector<T>& values) {
    device_.write(slot, values.data(), 0, values.size() * sizeof(T));
  }
  template <typename T>
  std::vector<T> read(uint slot, uint64_t count) {
    std::vector<T> values(count);
    device_.read(slot, values.data(), 0, count * sizeof(T));
    return values;
  }

  // Throws BackendError naming the buffer when a kernel wrote behind the end of one.
  void check_guards();

 private:
  uint64_t fitting(uint64_t bytes) const;

  Device& device_;
  uint64_t spheres_ = 0;
  std::array<uint64_t, SLOT_TOTAL> bytes_{};  // without the guard words
};

}  // namespace spherepair
