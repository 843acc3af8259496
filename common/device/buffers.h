// SPDX-License-Identifier: MIT
// The buffers that the kernels of one simulation see, one for each slot (layout.h), with guard words at their ends.
#pragma once

#include <array>
#include <vector>

#include "common/device/device.h"

namespace spherepair {

class Buffers {
 public:
  explicit Buffers(Device& device) : device_(device) {}
  ~Buffers();
  Buffers(const Buffers&) = delete;
  Buffers& operator=(const Buffers&) = delete;

  // Sets the number of spheres, for error messages.
  void set_spheres(uint64_t n) { spheres_ = n; }

  // Gives the slot a buffer of this many bytes. The contents survive only if the size stays the same. Throws
  // BackendError if a kernel cannot reach a buffer of this size or memory has no room.
  void resize(uint slot, uint64_t bytes);
  bool grow(uint slot, uint64_t bytes);  // resizes a smaller buffer; true: its contents are lost
  uint64_t bytes(uint slot) const { return memory_[slot].bytes; }
  const BufferHandles& handles() const { return handles_; }

  // share() puts a buffer into the slot that may have other owners, too; an empty Memory empties the slot.
  const Memory& memory(uint slot) const { return memory_[slot]; }
  void share(uint slot, const Memory& memory);
  void forget();  // empties all slots

  void write(uint slot, const void* data, uint64_t offset, uint64_t bytes) {
    device_.write(memory_[slot], data, offset, bytes);
  }
  void read(uint slot, void* data, uint64_t offset, uint64_t bytes) {
    device_.read(memory_[slot], data, offset, bytes);
  }
  void clear(uint slot, uint64_t bytes) { device_.clear(memory_[slot], bytes); }
  template <typename T>
  void write(uint slot, const std::vector<T>& values) {
    write(slot, values.data(), 0, values.size() * sizeof(T));
  }
  template <typename T>
  std::vector<T> read(uint slot, uint64_t count) {
    std::vector<T> values(count);
    read(slot, values.data(), 0, count * sizeof(T));
    return values;
  }

  // Throws BackendError if a kernel wrote past the end of a buffer; the message names the buffer.
  void check_guards();

 private:
  uint64_t fitting(uint64_t bytes) const;

  Device& device_;
  uint64_t spheres_ = 0;
  std::array<Memory, SLOT_TOTAL> memory_;  // sizes without the guard words
  BufferHandles handles_{};                // handles of memory_
};

}  // namespace spherepair
