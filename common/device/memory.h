// SPDX-License-Identifier: MIT
// Device memory.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "common/shared/layout.h"

namespace spherepair {

// A buffer of a device. Copies share it; destroying the last one frees it, which must be before the device is closed.
struct Memory {
  uint64_t handle = 0;  // for kernels: an OpenGL buffer's name, a CUDA address; 0: no buffer
  uint64_t bytes = 0;   // that kernels may use
  std::shared_ptr<void> owner;
};

using BufferHandles = std::array<uint64_t, SLOT_TOTAL>;  // by slot

}  // namespace spherepair
