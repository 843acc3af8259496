// SPDX-License-Identifier: MIT
// Memory of a device.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "common/shared/layout.h"

namespace spherepair {

// A buffer of a device. Copies share it, and the last one frees it. Free it before the device is closed.
struct Memory {
  uint64_t handle = 0;  // what kernels find it by: the name of an OpenGL buffer, an address in CUDA; 0: there is none
  uint64_t bytes = 0;   // that kernels may use
  std::shared_ptr<void> owner;
};

using BufferHandles = std::array<uint64_t, SLOT_TOTAL>;  // by slot

}  // namespace spherepair
