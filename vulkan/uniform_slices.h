// SPDX-License-Identifier: MIT
// Holds parameters of launches in slices of one mapped buffer; a dispatch binds one by its offset. A command that
// writes them would cost 11 us a launch (NVIDIA H100).
#pragma once

#include <cstring>

#include "vulkan/device/device_buffer.h"

namespace spherepair {

class UniformSlices {
 public:
  static constexpr uint32_t slice_bytes = 512;  // a multiple of every driver's alignment, which is 256 at most

  UniformSlices(const LogicalDevice& device, uint32_t slices)
      : buffer_(device, uint64_t(slices) * slice_bytes, Place::parameters), slices_(slices) {}

  VkBuffer buffer() const { return buffer_.handle(); }
  uint32_t left() const { return slices_ - used_; }

  // The offset of a slice with these bytes. Reuses one of the last four if its bytes are the same.
  uint32_t offset_of(const void* data, size_t bytes) {
    for (const Written& one : recent_)
      if (one.bytes == bytes && std::memcmp(one.data, data, bytes) == 0) return one.offset;
    Written& written = recent_[used_ % recent_.size()];
    written.bytes = bytes;
    written.offset = used_++ * slice_bytes;
    std::memcpy(written.data, data, bytes);
    std::memcpy(buffer_.mapped() + written.offset, data, bytes);
    return written.offset;
  }

  void forget() {  // all slices; the device must have finished the commands that read them
    used_ = 0;
    recent_ = {};
  }

 private:
  struct Written {
    size_t bytes = 0;
    uint32_t offset = 0;
    unsigned char data[slice_bytes];
  };

  DeviceBuffer buffer_;
  uint32_t slices_, used_ = 0;
  std::array<Written, 4> recent_{};
};

}  // namespace spherepair
