// SPDX-License-Identifier: MIT
// Transfers between host arrays and buffers, through small mapped buffers: threads copy one of them while the device
// transfers the other.
#pragma once

#include <array>

#include "vulkan/command_stream.h"
#include "vulkan/device/device_buffer.h"

namespace spherepair {

class Staging {
 public:
  Staging(const LogicalDevice& device, CommandStream& stream);

  void write(VkBuffer buffer, const char* data, uint64_t offset, uint64_t bytes);  // `data` may be reused on return
  void read(VkBuffer buffer, char* data, uint64_t offset, uint64_t bytes);         // waits for the device

 private:
  struct Piece {
    Piece(const LogicalDevice& device, Place place);
    DeviceBuffer buffer;
    uint64_t used = 0;    // bytes, from the start on
    uint64_t number = 0;  // of the last submission that reads or writes it
  };
  void copy(VkBuffer from, VkBuffer to, const VkBufferCopy& range);
  Piece& with_room();

  const Calls& vk_;
  CommandStream& stream_;
  std::array<Piece, 2> up_, down_;
  size_t turn_ = 0;  // the next of up_
};

}  // namespace spherepair
