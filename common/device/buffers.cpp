// SPDX-License-Identifier: MIT
#include "common/device/buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace spherepair {
namespace {

constexpr uint guard_words = 16;
constexpr uint guard_pattern = 0xA5C3F00Du;
#define ONE(slot, type, name, words) words,
#define THREE(slot, type, name, words) words " along x", words " along y", words " along z",
constexpr const char* slot_names[] = {SPHEREPAIR_BUFFERS(ONE, THREE)};
#undef ONE
#undef THREE
static_assert(std::size(slot_names) == SLOT_TOTAL);

}  // namespace

// Returns how many spheres fit into one buffer, given that the current number takes this many bytes.
uint64_t Buffers::fitting(uint64_t bytes) const {
  const uint64_t room = (device_.capabilities().largest_buffer - guard_words * sizeof(uint)) / 16 * 16;
  return uint64_t(double(room) / double(bytes) * double(spheres_));
}

void Buffers::resize(uint slot, uint64_t bytes) {
  bytes = ceil_div(std::max<uint64_t>(bytes, 16), 16) * 16;
  const uint64_t whole = bytes + guard_words * sizeof(uint), largest = device_.capabilities().largest_buffer;
  if (whole > largest) {
    throw BackendError(fmt::format(
        "{}: {} spheres need {} bytes for the {} ({:.3g} a sphere), but a kernel of this device can bind at "
        "most {}; {} spheres fit",
        device_.info().name, spheres_, whole, slot_names[slot], double(bytes) / double(spheres_), largest,
        fitting(bytes)));
  }
  if (memory_[slot].bytes == bytes) return;
  handles_[slot] = 0;  // stays 0 if the allocation fails
  Memory memory = device_.allocate(whole, std::exchange(memory_[slot], {}));
  memory.bytes = bytes;
  share(slot, memory);
  const std::vector<uint> guard(guard_words, guard_pattern);
  write(slot, guard.data(), bytes, guard_words * sizeof(uint));
}

// Flushes first, because launches that are held back still use the replaced memory.
void Buffers::share(uint slot, const Memory& memory) {
  if (memory_[slot].owner && memory_[slot].owner != memory.owner) device_.flush();
  memory_[slot] = memory;
  handles_[slot] = memory.handle;
}

Buffers::~Buffers() {
  try {
    forget();
  } catch (const BackendError&) {  // the device has failed and reported it before
  }
}

void Buffers::forget() {
  device_.flush();
  memory_ = {};
  handles_ = {};
}

bool Buffers::grow(uint slot, uint64_t bytes) {
  if (memory_[slot].bytes >= bytes) return false;
  resize(slot, bytes);
  return true;
}

void Buffers::check_guards() {
  for (uint slot = 0; slot < SLOT_TOTAL; ++slot) {
    if (!memory_[slot].bytes) continue;
    std::vector<uint> guard(guard_words);
    read(slot, guard.data(), memory_[slot].bytes, guard_words * sizeof(uint));
    if (std::ranges::any_of(guard, [](uint word) { return word != guard_pattern; })) {
      throw BackendError(
          fmt::format("{}: something was written behind the end of the {}", device_.info().name, slot_names[slot]));
    }
  }
}

}  // namespace spherepair
