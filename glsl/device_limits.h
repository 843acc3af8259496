// SPDX-License-Identifier: MIT
// What the driver of the current context offers.
#pragma once

#include "common/backend/backend.h"
#include "glsl/driver_memory.h"
#include "glsl/program.h"

namespace spherepair {

struct DeviceLimits {
  uint64_t largest_binding = 0;  // bytes of a storage block
  uint64_t largest_texture = 0;  // texels of a texture buffer
  Features features;
  bool sparse = false;      // the driver has sparse storage
  bool large_pages = true;  // are wanted
  bool vendor_free = false;
};

// Throws BackendError for a driver without what every kernel needs.
DeviceLimits device_limits(const OpenOptions& options);

// The buffers of a context: large ones in the driver's own memory where it is to be had, in sparse storage else.
class BufferMemory {
 public:
  explicit BufferMemory(const DeviceLimits& limits) : limits_(limits) {}

  // Throws BackendError with the bytes asked and free.
  BufferStorage allocate(uint64_t bytes);

 private:
  const DeviceLimits& limits_;
  bool opened_ = false;
  std::unique_ptr<DriverMemory> driver_;
};

// In words, with what to do.
std::string texture_too_long(uint64_t texels, const DeviceLimits& limits);

BackendInfo describe_device(bool software, const DeviceLimits& limits);

}  // namespace spherepair
