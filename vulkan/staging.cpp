// SPDX-License-Identifier: MIT
#include "vulkan/staging.h"

#include <omp.h>

#include <algorithm>
#include <cstring>

namespace spherepair {
namespace {

constexpr uint64_t piece_bytes = 4 << 20;

// Copies with eight threads, which saturate the bus.
void copy_bytes(char* to, const char* from, uint64_t bytes) {
  constexpr uint64_t part = 64 << 10;
  if (bytes <= part) return void(std::memcpy(to, from, bytes));
#pragma omp parallel for num_threads(std::min(8, omp_get_max_threads())) schedule(static)
  for (uint64_t at = 0; at < bytes; at += part) std::memcpy(to + at, from + at, std::min(part, bytes - at));
}

}  // namespace

Staging::Piece::Piece(const LogicalDevice& device, Place place) : buffer(device, piece_bytes, place) {}

Staging::Staging(const LogicalDevice& device, CommandStream& stream)
    : vk_(device.calls()),
      stream_(stream),
      up_{Piece(device, Place::uploads), Piece(device, Place::uploads)},
      down_{Piece(device, Place::downloads), Piece(device, Place::downloads)} {}

void Staging::copy(VkBuffer from, VkBuffer to, const VkBufferCopy& range) {
  const VkCommandBuffer commands = stream_.open();
  barrier_before_transfer(vk_, commands);
  vk_.CmdCopyBuffer(commands, from, to, 1, &range);
  barrier_behind_transfer(vk_, commands);
}

Staging::Piece& Staging::with_room() {
  if (up_[turn_].used == piece_bytes) {
    stream_.submit();
    turn_ = (turn_ + 1) % up_.size();
    stream_.wait(up_[turn_].number);
    up_[turn_].used = 0;
  }
  return up_[turn_];
}

void Staging::write(VkBuffer buffer, const char* data, uint64_t offset, uint64_t bytes) {
  for (uint64_t at = 0; at < bytes;) {
    Piece& piece = with_room();
    const uint64_t part = std::min(piece_bytes - piece.used, bytes - at);
    copy_bytes(piece.buffer.mapped() + piece.used, data + at, part);
    copy(piece.buffer.handle(), buffer, {piece.used, offset + at, part});
    piece.used += part;
    piece.number = stream_.number();
    stream_.recorded();
    at += part;
  }
}

void Staging::read(VkBuffer buffer, char* data, uint64_t offset, uint64_t bytes) {
  const auto request = [&](uint64_t at, Piece& piece) {
    copy(buffer, piece.buffer.handle(), {offset + at, 0, std::min(piece_bytes, bytes - at)});
    piece.number = stream_.number();
    stream_.submit();
  };
  request(0, down_[0]);
  for (uint64_t at = 0, turn = 0; at < bytes; at += piece_bytes, ++turn) {
    if (at + piece_bytes < bytes) request(at + piece_bytes, down_[(turn + 1) % 2]);
    stream_.wait(down_[turn % 2].number);
    copy_bytes(data + at, down_[turn % 2].buffer.mapped(), std::min(piece_bytes, bytes - at));
  }
}

}  // namespace spherepair
